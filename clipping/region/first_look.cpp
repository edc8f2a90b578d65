// SPDX-License-Identifier: MIT
#include "clipping/region/first_look.h"

#include "clipping/ieee_numbers.h"

namespace clipping {

// Without branches, which would often be mispredicted. Where no cell lists an edge, everything in
// them is kept or nothing is, and so is everything off the grid next to them.
inline FirstLook::Known FirstLook::at(const Segment& s) const
{
    using Two [[gnu::vector_size(2 * sizeof(double))]] = double;
    const Two a{s.a.x, s.a.y}, b{s.b.x, s.b.y}, zero = (a - a) + (b - b);
    const Two low = a < b ? a : b, high = a < b ? b : a;
    const auto& [min, max] = grid_.box();
    const auto isOff = (zero != 0.0) | (high < Two{min.x, min.y}) | (low > Two{max.x, max.y});
    const auto off = static_cast<unsigned>(isOff[0] | isOff[1]) | hasNoEdge_; // 0 or all bits
    const SearchGrid::Block block = grid_.blockOf(s);
    const unsigned edged = grid_.hasEdges(block), kept = grid_.keepsReference[grid_.firstIn(block)];
    return Known((off & none_) | (~off & (2 * edged | (kept & ~edged))));
}

std::span<const FirstLook::Seen> FirstLook::at(std::span<const Segment> segments)
{
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < segments.size(); ++i) {
        const Known known = at(segments[i]);
        seen_[count] = {i, known};
        count += known != Known::Gone;
    }
    return std::span(seen_).first(count);
}

} // namespace clipping
