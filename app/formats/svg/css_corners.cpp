// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/css_corners.h"

#include "app/formats/svg/arc.h"
#include "app/formats/svg/scanner.h"

#include <algorithm>

namespace app::svg {
namespace {

// Four values of one to four: as CSS repeats them for the sides or corners of a box.
std::optional<std::array<double, 4>> fourRadii(std::string_view text, double whole,
                                               const Lengths& lengths)
{
    const auto words = wordsOf(text);
    if (words.empty() || words.size() > 4)
        return std::nullopt;
    std::array<double, 4> radii{};
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t from = i < words.size() ? i : i == 3 && words.size() > 1 ? 1 : 0;
        const auto length = lengths.parse(words[from], whole);
        if (!length || *length < 0 || lacksUnit(words[from]))
            return std::nullopt;
        radii[i] = *length;
    }
    return radii;
}

// The corners share the sides of the box.
double shareOf(const CornerRadii& radii, const Point& size)
{
    double share = 1;
    const auto fit = [&](double side, double both) {
        if (both > side)
            share = std::min(share, side / both);
    };
    fit(size.x, radii[0].x + radii[1].x);
    fit(size.x, radii[2].x + radii[3].x);
    fit(size.y, radii[1].y + radii[2].y);
    fit(size.y, radii[3].y + radii[0].y);
    return share;
}

} // namespace

std::optional<CornerRadii> cornerRadii(std::string_view text, const Point& size,
                                       const Lengths& lengths)
{
    const auto slash = text.find('/');
    const auto across = fourRadii(text.substr(0, slash), size.x, lengths);
    const auto down =
        fourRadii(slash == text.npos ? text : text.substr(slash + 1), size.y, lengths);
    if (!across || !down)
        return std::nullopt;
    CornerRadii radii;
    for (std::size_t i = 0; i < 4; ++i)
        radii[i] = {(*across)[i], (*down)[i]};
    const double share = shareOf(radii, size);
    for (Point& radius : radii)
        radius *= share;
    return radii;
}

Subpath roundedBox(const Box& box, const CornerRadii& radii)
{
    const Point min = box.min, max = box.min + box.size;
    const std::array corners{min, Point{max.x, min.y}, max, Point{min.x, max.y}};
    constexpr std::array<Point, 4> along{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}}; // the sides
    Subpath path{corners[0] + along[0] * radii[0], {}, true};
    for (std::size_t i = 1; i <= 4; ++i) {
        const Point &corner = corners[i % 4], &radius = radii[i % 4];
        const Point from = corner - along[i - 1] * radius, to = corner + along[i % 4] * radius;
        path.segments.push_back({from});
        if (radius.x > 0 && radius.y > 0)
            appendArc(path.segments, {from, to, radius, 0, false, true});
    }
    return path;
}

} // namespace app::svg
