// SPDX-License-Identifier: MIT
#include "clipping/region/box_part.h"

#include "clipping/ieee_numbers.h"
#include "clipping/region/prepared.h"

#include <glm/common.hpp>

#include <algorithm>

namespace clipping {
namespace {

bool areApart(const Window& p, const Window& q)
{
    return p.max.x < q.min.x || p.min.x > q.max.x || p.max.y < q.min.y || p.min.y > q.max.y;
}

/// Whether a segment has no point in a box.
bool misses(const Segment& s, const Window& box)
{
    if (areApart({glm::min(s.a, s.b), glm::max(s.a, s.b)}, box))
        return true;
    const int side = leftOf(s.a, s.b, box.min).sign;
    return side != 0 && leftOf(s.a, s.b, box.max).sign == side
           && leftOf(s.a, s.b, {box.min.x, box.max.y}).sign == side
           && leftOf(s.a, s.b, {box.max.x, box.min.y}).sign == side;
}

} // namespace

BoxPart partOf(const Window& box, const PreparedRegion& region)
{
    const PreparedRegion::Data& data = region.data();
    const auto known = [](bool isKept) { return isKept ? BoxPart::Whole : BoxPart::None; };
    if (data.edges.empty() || areApart(box, data.grid.box()))
        return known(data.keepsNone);
    bool isFree = true;
    data.grid.trace(box, [&](std::size_t first, std::size_t last) {
        isFree = isFree && std::ranges::all_of(data.grid.edgesIn(first, last), [&](auto i) {
                     return misses(data.edges[i].segment, box);
                 });
    });
    if (!isFree)
        return BoxPart::Undecided;
    return known(!clip({box.min, box.min}, region).empty());
}

} // namespace clipping
