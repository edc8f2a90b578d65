// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/clipping/contract.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>

using clipping::Segment;
using clipping::Window;

namespace {

oracle::Line line(const Segment& s) { return {{s.a.x, s.a.y}, {s.b.x, s.b.y}}; }
oracle::Box box(const Window& w) { return {{w.min.x, w.min.y}, {w.max.x, w.max.y}}; }

std::string text(const Segment& s)
{
    char buffer[200];
    std::snprintf(buffer, sizeof buffer, "Segment{{%a, %a}, {%a, %a}}", s.a.x, s.a.y, s.b.x, s.b.y);
    return buffer;
}

bool within(const glm::dvec2& p, const Window& w) // false for a number that is none
{
    return p.x >= w.min.x && p.x <= w.max.x && p.y >= w.min.y && p.y <= w.max.y;
}

bool sameBits(const glm::dvec2& p, const glm::dvec2& q)
{
    return std::memcmp(&p, &q, sizeof p) == 0;
}

} // namespace

bool sameBits(const Segment& s, const Segment& t) { return std::memcmp(&s, &t, sizeof s) == 0; }

std::string exactly(const Input& input)
{
    const Window& w = input.window;
    char buffer[200];
    std::snprintf(buffer, sizeof buffer, ", Window{{%a, %a}, {%a, %a}}", w.min.x, w.min.y, w.max.x,
                  w.max.y);
    return text(input.segment) + buffer;
}

std::optional<oracle::Part> truthOf(const Input& input)
{
    return oracle::inside(line(input.segment), box(input.window));
}

double ulpsOff(const std::optional<Segment>& result, const Input& input,
               const std::optional<oracle::Part>& truth)
{
    if (!result || !truth)
        return 0;
    const long double ulp = oracle::ulp(line(input.segment), box(input.window));
    const auto off = [&](double x, double y) { return std::abs((long double)x - y) / ulp; };
    const auto& [a, b] = truth->line;
    return double(std::max({off(result->a.x, a.x), off(result->a.y, a.y), off(result->b.x, b.x),
                            off(result->b.y, b.y)}));
}

std::string fault(const std::optional<Segment>& result, const Input& input,
                  const std::optional<oracle::Part>& truth, double k)
{
    const auto& [s, w] = input;
    const auto ulps = static_cast<int>(k);
    if (!result)
        return truth && oracle::meets(line(s), box(w), -ulps) ? "lost" : "";
    if (!within(result->a, w) || !within(result->b, w))
        return "outside the window: " + text(*result);
    if (!truth)
        return oracle::meets(line(s), box(w), ulps)
                   ? ""
                   : "seen where there is nothing: " + text(*result);
    if ((within(s.a, w) && !sameBits(result->a, s.a))
        || (within(s.b, w) && !sameBits(result->b, s.b)))
        return "an inner end has moved: " + text(*result);
    if (ulpsOff(result, input, truth) > std::max(k - 1, 0.0)) // the truth is rounded, too
        return "off by " + std::to_string(ulpsOff(result, input, truth))
               + " ulps: " + text(*result);
    return {};
}
