// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/box_in_outline.h"

#include <cmath>

namespace app {

namespace {

// The side of the line from a to b on which p lies: 1 left (if y points up), -1 right, 0 not sure.
// The cross product is off by less than 4e-16 of the sum of its two products; underflow is left to
// `tiny`.
int sideOf(const Point& a, const Point& b, const Point& p)
{
    constexpr double bound = 1e-15, tiny = 1e-290;
    const double one = (b.x - a.x) * (p.y - a.y), other = (b.y - a.y) * (p.x - a.x);
    const double value = one - other, error = bound * (std::abs(one) + std::abs(other)) + tiny;
    return value > error ? 1 : value < -error ? -1 : 0; // 0 for NaN, too: an overflow
}

// Whether no point of the edge is in the box, for certain.
bool misses(const Point& a, const Point& b, const clipping::Window& box)
{
    const auto& [min, max] = box;
    if ((a.x < min.x && b.x < min.x) || (a.x > max.x && b.x > max.x) || (a.y < min.y && b.y < min.y)
        || (a.y > max.y && b.y > max.y))
        return true;
    const int side = sideOf(a, b, min);
    return side != 0 && sideOf(a, b, {max.x, min.y}) == side && sideOf(a, b, max) == side
           && sideOf(a, b, {min.x, max.y}) == side;
}

/// The winding number of the rings around a point that is on no edge.
class Winding {
public:
    explicit Winding(const Point& p) : p_(p) {}

    /// False: not sure.
    bool add(const Point& a, const Point& b)
    {
        if ((a.y <= p_.y) == (b.y <= p_.y))
            return true;
        const int side = sideOf(a, b, p_);
        const bool up = b.y > a.y;
        if (side == (up ? 1 : -1)) // the edge is to the right of the point
            number_ += side;
        return side != 0;
    }
    bool isInside(FillRule rule) const
    {
        return rule == FillRule::EvenOdd ? number_ % 2 != 0 : number_ != 0;
    }

private:
    Point p_;
    int number_ = 0;
};

} // namespace

Share shareOfBox(const std::vector<std::vector<Point>>& rings, FillRule rule,
                 const clipping::Window& box)
{
    std::size_t edges = 0;
    for (const auto& ring : rings)
        edges += ring.size();
    if (edges > mostEdgesForBoxes)
        return Share::Some;
    Winding winding(box.min);
    for (const auto& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point &a = ring[i], &b = ring[i + 1 < ring.size() ? i + 1 : 0];
            if (!misses(a, b, box) || !winding.add(a, b))
                return Share::Some;
        }
    return winding.isInside(rule) ? Share::All : Share::None;
}

} // namespace app
