// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/snap.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace app {
namespace {

// The nearer of the bounds low and high, if within `radius`.
std::optional<double> edge(double at, double low, double high, double radius)
{
    const double best = std::abs(at - low) <= std::abs(at - high) ? low : high;
    return std::abs(at - best) <= radius ? std::optional(best) : std::nullopt;
}

std::optional<Snap> snapToWindow(const Point& p, double radius, const clipping::Window& w)
{
    const bool besideX = p.x >= w.min.x - radius && p.x <= w.max.x + radius;
    const bool besideY = p.y >= w.min.y - radius && p.y <= w.max.y + radius;
    const auto x = besideY ? edge(p.x, w.min.x, w.max.x, radius) : std::nullopt;
    const auto y = besideX ? edge(p.y, w.min.y, w.max.y, radius) : std::nullopt;
    if (!x && !y)
        return std::nullopt;
    return Snap{{x.value_or(p.x), y.value_or(p.y)}, SnapTo::WindowEdges};
}

} // namespace

std::optional<Snap> snap(const Point& pointer, double radius,
                         std::span<const clipping::Segment> segments,
                         const std::optional<clipping::Window>& window, SnapTo to)
{
    std::optional<Snap> best;
    double least = radius;
    const auto offer = [&](const Point& p, SnapTo what) {
        const double d = glm::distance(p, pointer);
        if ((to & what) && d <= least) {
            least = d;
            best = Snap{p, what};
        }
    };
    for (const auto& s : segments) {
        offer(s.a + (s.b - s.a) * 0.5, SnapTo::Middles);
        offer(s.a, SnapTo::Ends);
        offer(s.b, SnapTo::Ends);
    }
    if (!best && window && (to & SnapTo::WindowEdges))
        return snapToWindow(pointer, radius, *window);
    return best;
}

} // namespace app
