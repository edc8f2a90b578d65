// SPDX-License-Identifier: MIT
#include "clipping/region/region.h"

#include "clipping/ieee_numbers.h"
#include "clipping/region/convex.h"
#include "clipping/region/first_look.h"
#include "clipping/region/sweep.h"

#include <glm/common.hpp>

#include <algorithm>

namespace clipping {
namespace {

using Known = FirstLook::Known;

/// A segment that meets more rows of small cells is swept through large ones.
constexpr std::size_t fewRows = 4;

/// A box as its middle and half its extent, for lines that pass it.
class PassedBox {
public:
    explicit PassedBox(const Window& box)
        : middle_(box.min / 2.0 + box.max / 2.0),
          // Larger than half the extent by more than the middle's rounding.
          half_((box.max / 2.0 - box.min / 2.0) * (1 + 0x1p-40)
                + 0x1p-50 * (glm::abs(box.min) + glm::abs(box.max)) + 0x1p-1070)
    {
    }
    /// Whether the line through a segment certainly passes the box without meeting it. Each
    /// computed term is off by less than 4 e of itself; infinities and NaNs decide nothing.
    bool isMissedBy(const Segment& s) const
    {
        const double dx = s.b.x - s.a.x, dy = s.b.y - s.a.y;
        const double p = dx * (middle_.y - s.a.y), q = dy * (middle_.x - s.a.x);
        const double reach = std::abs(dx) * half_.y + std::abs(dy) * half_.x;
        return std::abs(p - q)
               > reach * (1 + 0x1p-40) + 0x1p-48 * (std::abs(p) + std::abs(q)) + tiny;
    }

private:
    glm::dvec2 middle_, half_;
};

/// The row `exact`: the first look, and a sweep where that leaves the answer open.
class ExactPieces {
public:
    ExactPieces(const PreparedRegion::Data& region, std::size_t segments)
        : region_(region), grid_(region.gridFor(segments)), look_(region, grid_),
          passed_(region.grid.box()), sweep_(region)
    {
    }
    std::span<const FirstLook::Seen> lookAt(std::span<const Segment> segments)
    {
        return look_.at(segments);
    }
    /// The kept pieces of a segment that was seen. Valid until the next call.
    std::span<const RegionPiece> of(const Segment& segment, std::uint32_t source, Known known)
    {
        bool isKept = known == Known::Whole;
        if (known == Known::Undecided) {
            if (!passed_.isMissedBy(segment))
                return sweep_.piecesOf(segment, source, gridFor(segment));
            isKept = region_.keepsNone;
        }
        whole_ = {segment, source, 0, 0};
        return {&whole_, isKept ? 1U : 0U};
    }

private:
    /// The one with smaller cells if the segment meets few of them.
    const RegionGrid& gridFor(const Segment& segment) const
    {
        const auto block = grid_.blockOf(segment);
        return block.top - block.bottom < fewRows ? grid_ : region_.grid;
    }

    const PreparedRegion::Data& region_;
    const RegionGrid& grid_;
    FirstLook look_;
    PassedBox passed_;
    LineSweep sweep_;
    RegionPiece whole_{};
};

RegionProgress clipEach(std::span<const Segment> in, ExactPieces& exact, std::span<RegionPiece> out,
                        RegionProgress from)
{
    while (from.segment < in.size()) {
        // Not much more than fits into the output.
        const std::size_t first = from.segment;
        const std::size_t room = 32 + 8 * (out.size() - from.written);
        const auto ahead =
            in.subspan(first, std::min({FirstLook::mostAtOnce, room, in.size() - first}));
        for (const auto& [index, known] : exact.lookAt(ahead)) {
            from.piece = first + index == from.segment ? from.piece : 0;
            from.segment = first + index;
            const auto source = static_cast<std::uint32_t>(from.segment);
            const auto kept = exact.of(ahead[index], source, known);
            for (; from.piece < kept.size(); ++from.piece) {
                if (from.written == out.size())
                    return from;
                out[from.written++] = kept[from.piece];
            }
        }
        from.segment = first + ahead.size(), from.piece = 0;
    }
    return from;
}

} // namespace

RegionProgress clipAll(std::span<const Segment> in, const PreparedRegion& region,
                       std::span<RegionPiece> out, RegionProgress from)
{
    if (const ConvexRegion* convex = region.data().convex.get()) {
        LineSweep sweep(region.data());
        return clipAllConvex(in, *convex, sweep, out, from);
    }
    from.written = 0;
    const std::size_t segments = std::min(in.size() - from.segment, out.size());
    ExactPieces exact(region.data(), segments);
    return clipEach(in, exact, out, from);
}

std::vector<RegionPiece> clip(const Segment& segment, const PreparedRegion& region)
{
    ExactPieces exact(region.data(), 1);
    const auto seen = exact.lookAt({&segment, 1});
    if (seen.empty())
        return {};
    const auto kept = exact.of(segment, 0, seen.front().known);
    return {kept.begin(), kept.end()};
}

} // namespace clipping
