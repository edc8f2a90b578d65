// SPDX-License-Identifier: MIT
#include "clipping/region/convex.h"

#include "clipping/batch/kernels.h"
#include "clipping/exact/turn.h"
#include "clipping/ieee_numbers.h"

#include <algorithm>
#include <array>

namespace clipping {
namespace {

/// The points of the only ring; none if there are more rings.
std::vector<glm::dvec2> onlyRing(const Area& area)
{
    if (area.ringEnds.size() > 1)
        return {};
    const std::size_t size = area.ringEnds.empty() ? area.points.size() : area.ringEnds.front();
    return {area.points.begin(), area.points.begin() + static_cast<std::ptrdiff_t>(size)};
}

/// Converts pieces of the kernel to pieces at a region.
class Conversion {
public:
    explicit Conversion(const ConvexRegion& region)
        : corners_(region.corners), isReversed_(region.isReversed)
    {
    }
    /// Whether an end may be at a corner; `number` is that of the edge that cuts it, or 0. At a
    /// corner it is that of the edge that begins there.
    bool isAtCorner(const glm::dvec2& end, std::uint32_t number) const
    {
        return number != 0 && end == corners_[number - 1];
    }
    std::uint32_t edgeOf(std::uint32_t number) const
    {
        if (number == 0 || !isReversed_)
            return number;
        const auto size = static_cast<std::uint32_t>(corners_.size());
        return number == size ? size : size - number;
    }

private:
    const std::vector<glm::dvec2>& corners_;
    bool isReversed_;
};

constexpr std::size_t segmentsAtOnce = 1024;

} // namespace

std::unique_ptr<const ConvexRegion> convexRegion(const Region& region)
{
    if (region.keep != Keep::Inside || region.steps.size() != 1
        || region.steps[0].operation == AreaOperation::CutOut)
        return nullptr;
    std::vector<glm::dvec2> corners = onlyRing(region.steps[0].area);
    if (corners.size() < 3 || corners.size() >= 0xffff)
        return nullptr;
    auto polygon = prepared({corners});
    const bool isReversed = !polygon;
    if (isReversed) {
        std::ranges::reverse(corners);
        polygon = prepared({corners});
    }
    if (!polygon || polygon->flat || !polygon->ordinary
        || polygon->corners.size() != corners.size())
        return nullptr;
    polygon->namesEveryCut = true;
    return std::make_unique<const ConvexRegion>(std::move(corners), std::move(*polygon),
                                                isReversed);
}

RegionProgress clipAllConvex(std::span<const Segment> in, const ConvexRegion& region,
                             LineSweep& sweep, std::span<RegionPiece> out, RegionProgress from)
{
    from.written = 0;
    const Conversion conversion(region);
    std::array<Clipped, segmentsAtOnce> block;
    while (from.segment < in.size()) {
        // Not much more than fits into the output.
        const std::size_t most = std::min(segmentsAtOnce, 32 + 2 * (out.size() - from.written));
        const std::size_t end = std::min(in.size(), from.segment + most);
        const std::size_t pieces =
            clipBatch(PolygonBatch{in.data(), from.segment, end, &region.polygon,
                                   &region.table.table(), block.data()})
                .pieces;
        for (const Clipped& piece : std::span(block).first(pieces)) {
            from.segment = piece.source;
            if (from.written == out.size())
                return from;
            const std::uint32_t a = polygonEdgeOfA(piece.cut), b = polygonEdgeOfB(piece.cut);
            const auto& s = piece.segment;
            out[from.written++] =
                conversion.isAtCorner(s.a, a) || conversion.isAtCorner(s.b, b)
                    ? sweep.piecesOf(in[piece.source], piece.source).front()
                    : RegionPiece{s, piece.source, conversion.edgeOf(a), conversion.edgeOf(b)};
        }
        from.segment = end;
    }
    return from;
}

} // namespace clipping
