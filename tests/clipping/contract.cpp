// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/clipping/contract.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

using clipping::BasicSegment;
using clipping::BasicWindow;

namespace {

oracle::Point point(const glm::dvec2& p) { return {p.x, p.y}; }
oracle::Point3 point(const glm::dvec3& p) { return {p.x, p.y, p.z}; }
glm::dvec2 point(const oracle::Point& p) { return {p.x, p.y}; }
glm::dvec3 point(const oracle::Point3& p) { return {p.x, p.y, p.z}; }

template <glm::length_t N>
auto line(const BasicSegment<double, N>& s)
{
    return oracle::BasicLine{point(s.a), point(s.b)};
}
template <glm::length_t N>
auto box(const BasicWindow<double, N>& w)
{
    return oracle::BasicBox{point(w.min), point(w.max)};
}

template <glm::length_t N>
std::string text(const glm::vec<N, double>& p, const glm::vec<N, double>& q)
{
    std::string all;
    for (const auto* r : {&p, &q})
        for (glm::length_t k = 0; k < N; ++k) {
            char buffer[40];
            std::snprintf(buffer, sizeof buffer, "%s%a", k == 0 ? "" : ", ", (*r)[k]);
            all += (k == 0 ? r == &p ? "{{" : "}, {" : "") + std::string(buffer);
        }
    return all + "}}";
}
template <glm::length_t N>
std::string text(const BasicSegment<double, N>& s)
{
    return "Segment" + text(s.a, s.b);
}

template <glm::length_t N>
bool within(const glm::vec<N, double>& p, const BasicWindow<double, N>& w)
{
    for (glm::length_t k = 0; k < N; ++k)
        if (!(p[k] >= w.min[k] && p[k] <= w.max[k])) // also if it is not finite
            return false;
    return true;
}

} // namespace

template <glm::length_t N>
std::string exactly(const BasicInput<N>& input)
{
    return text(input.segment) + ", Window" + text(input.window.min, input.window.max);
}

template <glm::length_t N>
Truth<N> truthOf(const BasicInput<N>& input)
{
    return oracle::inside(line(input.segment), box(input.window));
}

template <glm::length_t N>
double ulpsOff(const std::optional<BasicSegment<double, N>>& result, const BasicInput<N>& input,
               const Truth<N>& truth, oracle::Number number)
{
    if (!result || !truth)
        return 0;
    const long double ulp = oracle::ulp(line(input.segment), box(input.window), number);
    const BasicSegment<double, N> is{point(truth->line.a), point(truth->line.b)};
    long double most = 0;
    for (const auto end : {&BasicSegment<double, N>::a, &BasicSegment<double, N>::b})
        for (glm::length_t k = 0; k < N; ++k)
            most = std::max(most, std::abs((long double)((*result).*end)[k] - (is.*end)[k]) / ulp);
    return double(most);
}

template <glm::length_t N>
std::string fault(const std::optional<BasicSegment<double, N>>& result, const BasicInput<N>& input,
                  const Truth<N>& truth, double k, oracle::Number number)
{
    const auto& [s, w] = input;
    const auto ulps = static_cast<int>(k);
    if (!result)
        return truth && oracle::meets(line(s), box(w), -ulps, number) ? "lost" : "";
    if (!within(result->a, w) || !within(result->b, w))
        return "outside the window: " + text(*result);
    if (!truth)
        return oracle::meets(line(s), box(w), ulps, number)
                   ? ""
                   : "seen where there is nothing: " + text(*result);
    if ((within(s.a, w) && !sameBits(result->a, s.a))
        || (within(s.b, w) && !sameBits(result->b, s.b)))
        return "an inner end has moved: " + text(*result);
    // The exact value is rounded to a double, too.
    const bool single = number == oracle::Number::Single;
    const double off = ulpsOff(result, input, truth, number);
    if (off > (single ? k + 1e-6 : std::max(k - 1, 0.0)))
        return "off by " + std::to_string(off) + " ulps: " + text(*result);
    return {};
}

// NOLINTBEGIN(bugprone-macro-parentheses): the argument of a template
#define FOR_DIMENSIONS(N)                                                                          \
    template std::string exactly(const BasicInput<N>&);                                            \
    template Truth<N> truthOf(const BasicInput<N>&);                                               \
    template double ulpsOff(const std::optional<BasicSegment<double, N>>&, const BasicInput<N>&,   \
                            const Truth<N>&, oracle::Number);                                      \
    template std::string fault(const std::optional<BasicSegment<double, N>>&,                      \
                               const BasicInput<N>&, const Truth<N>&, double, oracle::Number)
// NOLINTEND(bugprone-macro-parentheses)
FOR_DIMENSIONS(2);
FOR_DIMENSIONS(3);
