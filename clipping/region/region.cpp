// SPDX-License-Identifier: MIT
#include "clipping/region/region.h"

#include "clipping/frame.h"
#include "clipping/ieee_numbers.h"
#include "clipping/region/convex.h"
#include "clipping/region/resume.h"
#include "clipping/region/sweep.h"

#include <glm/common.hpp>

namespace clipping {
namespace {

/// What the region's bounding box and grid tell about a segment, before any edge is tested.
enum class Known : std::uint8_t { Gone, Whole, Undecided };

Known known(bool isKept) { return isKept ? Known::Whole : Known::Gone; }

/// Without branches, which would often be mispredicted.
bool areApart(const Segment& s, const Window& box)
{
    const glm::dvec2 low = glm::min(s.a, s.b), high = glm::max(s.a, s.b);
    return ((high.x < box.min.x) | (low.x > box.max.x) | (high.y < box.min.y) | (low.y > box.max.y))
           != 0;
}

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

/// Looks at a segment as far as the grid alone can tell.
class FirstLook {
public:
    explicit FirstLook(const PreparedRegion::Data& region)
        : region_(region), passed_(region.grid.box())
    {
    }
    Known at(const Segment& s) const
    {
        if (region_.edges.empty() || !legal(s) || areApart(s, region_.grid.box()))
            return known(region_.keepsNone);
        const std::size_t cell = region_.grid.cellOf(s.a);
        if (cell == region_.grid.cellOf(s.b))
            return region_.grid.hasEdges(cell) ? Known::Undecided
                                               : known(region_.keepsReference[cell]);
        return passed_.isMissedBy(s) ? known(region_.keepsNone) : Known::Undecided;
    }

private:
    const PreparedRegion::Data& region_;
    PassedBox passed_;
};

/// The row `exact`: the first look, and the sweep where that leaves the answer open.
class ExactPieces {
public:
    explicit ExactPieces(const PreparedRegion::Data& region) : look_(region), sweep_(region) {}

    std::span<const RegionPiece> of(const Segment& segment, std::uint32_t source)
    {
        const Known answer = look_.at(segment);
        if (answer == Known::Undecided)
            return sweep_.piecesOf(segment, source);
        whole_ = {segment, source, 0, 0};
        return {&whole_, answer == Known::Whole ? 1U : 0U};
    }

private:
    FirstLook look_;
    LineSweep sweep_;
    RegionPiece whole_{};
};

} // namespace

RegionProgress clipAll(std::span<const Segment> in, const PreparedRegion& region,
                       std::span<RegionPiece> out, RegionProgress from)
{
    if (const ConvexRegion* convex = region.data().convex.get()) {
        LineSweep sweep(region.data());
        return clipAllConvex(in, *convex, sweep, out, from);
    }
    ExactPieces pieces(region.data());
    return clipEach(in, pieces, out, from);
}

std::vector<RegionPiece> clip(const Segment& segment, const PreparedRegion& region)
{
    ExactPieces pieces(region.data());
    return piecesOf(segment, pieces);
}

} // namespace clipping
