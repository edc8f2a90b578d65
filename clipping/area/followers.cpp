// SPDX-License-Identifier: MIT
#include "clipping/area/vertices.h"
#include "clipping/exact/turn.h"
#include "clipping/ieee_numbers.h"
#include "clipping/region/beside.h"

#include <algorithm>
#include <cassert>

namespace clipping {
namespace {

/// A piece as seen from one of its ends.
struct PieceEnd {
    std::uint32_t piece;
    bool arrives;        ///< whether it ends here
    glm::dvec2 from, to; ///< its direction, away from here

    /// Whether it points upwards, or exactly to the right.
    bool isUpper() const
    {
        const int up = signOf(from.y, to.y);
        return up != 0 ? up > 0 : signOf(from.x, to.x) > 0;
    }
    /// Whether it comes before another one, clockwise from the left.
    bool comesBefore(const PieceEnd& other) const
    {
        if (isUpper() != other.isUpper())
            return isUpper();
        return cross(to - from, from, to, other.from, other.to).sign < 0;
    }
};

std::vector<PieceEnd> endsAt(std::uint32_t vertex, std::span<const BoundaryPiece> pieces,
                             const BoundaryVertices& vertices)
{
    std::vector<PieceEnd> ends;
    for (const std::uint32_t i : vertices.endingAt(vertex))
        ends.push_back({i, true, pieces[i].ahead(), pieces[i].behind()});
    for (const std::uint32_t i : vertices.beginningAt(vertex))
        ends.push_back({i, false, pieces[i].behind(), pieces[i].ahead()});
    std::ranges::sort(ends, [](const PieceEnd& p, const PieceEnd& q) { return p.comesBefore(q); });
    return ends;
}

} // namespace

std::vector<std::uint32_t> followers(std::span<const BoundaryPiece> pieces,
                                     const BoundaryVertices& vertices)
{
    std::vector<std::uint32_t> follower(pieces.size());
    std::vector<std::uint32_t> open; // pieces that arrived and have none yet
    for (std::uint32_t vertex = 0; vertex < vertices.count(); ++vertex) {
        const auto ending = vertices.endingAt(vertex);
        if (ending.size() == 1) {
            follower[ending[0]] = vertices.beginningAt(vertex)[0];
            continue;
        }
        // The result is clockwise of a piece that arrives, until one leaves. Twice around, as the
        // first ones may belong to the last ones.
        const auto ends = endsAt(vertex, pieces, vertices);
        std::vector<bool> isDone(ends.size());
        open.clear();
        for (std::size_t i = 0; i < 2 * ends.size(); ++i) {
            const PieceEnd& end = ends[i % ends.size()];
            if (isDone[i % ends.size()] || (end.arrives && i >= ends.size()))
                continue;
            if (end.arrives) {
                open.push_back(end.piece);
            } else if (!open.empty()) {
                follower[open.back()] = end.piece;
                open.pop_back();
            } else {
                continue;
            }
            isDone[i % ends.size()] = true;
        }
        assert(open.empty());
    }
    return follower;
}

} // namespace clipping
