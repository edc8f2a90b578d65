// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/area.h"

namespace app {
namespace {

// Clips the outline to the half plane sign * (p[axis] - bound) >= 0.
std::vector<Point> half(std::span<const Point> outline, int axis, double bound, double sign)
{
    std::vector<Point> kept;
    kept.reserve(outline.size() + 4);
    const auto depth = [&](const Point& p) { return sign * (p[axis] - bound); };
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point& from = outline[i == 0 ? outline.size() - 1 : i - 1];
        const Point& to = outline[i];
        if ((depth(from) < 0) != (depth(to) < 0)) {
            Point cut = from + (to - from) * (depth(from) / (depth(from) - depth(to)));
            cut[axis] = bound;
            kept.push_back(cut);
        }
        if (depth(to) >= 0)
            kept.push_back(to);
    }
    return kept;
}

} // namespace

std::vector<Point> areaInside(std::span<const Point> outline, const clipping::Window& window)
{
    std::vector<Point> kept = half(outline, 0, window.min.x, 1);
    kept = half(kept, 0, window.max.x, -1);
    kept = half(kept, 1, window.min.y, 1);
    return half(kept, 1, window.max.y, -1);
}

} // namespace app
