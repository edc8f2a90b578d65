// SPDX-License-Identifier: MIT
#include "clipping/area/vertices.h"
#include "clipping/exact/turn.h"
#include "clipping/ieee_numbers.h"
#include "clipping/region/beside.h"

#include <algorithm>
#include <cassert>

namespace clipping {
namespace {

/// Whether a direction points upwards, or exactly to the right.
bool pointsUp(const glm::dvec2& from, const glm::dvec2& to)
{
    const int up = signOf(from.y, to.y);
    return up != 0 ? up > 0 : signOf(from.x, to.x) > 0;
}

/// A piece as seen from one of its ends.
struct PieceEnd {
    PieceEnd(std::uint32_t number, bool ends, const glm::dvec2& here, const glm::dvec2& away)
        : piece(number), arrives(ends), isUpper(pointsUp(here, away)), from(&here), to(&away)
    {
    }
    /// Whether it comes before another one, clockwise from the left.
    bool comesBefore(const PieceEnd& other) const
    {
        if (isUpper != other.isUpper)
            return isUpper;
        return cross(*to - *from, *from, *to, *other.from, *other.to).sign < 0;
    }

    std::uint32_t piece;
    bool arrives; ///< whether it ends here
    bool isUpper;
    const glm::dvec2 *from, *to; ///< its direction, away from here
};

/// The ends at a vertex, in order; into memory that is used again.
void findEnds(std::uint32_t vertex, std::span<const BoundaryPiece> pieces,
              const BoundaryVertices& vertices, std::vector<PieceEnd>& ends)
{
    ends.clear();
    for (const std::uint32_t i : vertices.endingAt(vertex))
        ends.emplace_back(i, true, pieces[i].ahead(), pieces[i].behind());
    for (const std::uint32_t i : vertices.beginningAt(vertex))
        ends.emplace_back(i, false, pieces[i].behind(), pieces[i].ahead());
    std::ranges::sort(ends, [](const PieceEnd& p, const PieceEnd& q) { return p.comesBefore(q); });
}

} // namespace

std::vector<std::uint32_t> followers(std::span<const BoundaryPiece> pieces,
                                     const BoundaryVertices& vertices, const std::stop_token& stop)
{
    std::vector<std::uint32_t> follower(pieces.size());
    std::vector<std::uint32_t> open; // pieces that arrived and have none yet
    std::vector<PieceEnd> ends;
    std::vector<bool> isDone;
    for (std::uint32_t vertex = 0; vertex < vertices.count(); ++vertex) {
        if (isStopped(stop, vertex))
            break;
        constexpr std::uint32_t soon = 8; // pieces of crossing edges are far apart in memory
        if (vertex + soon < vertices.count())
            for (const std::uint32_t i : vertices.endingAt(vertex + soon))
                __builtin_prefetch(&pieces[i]);
        const auto ending = vertices.endingAt(vertex);
        if (ending.size() == 1) {
            follower[ending[0]] = vertices.beginningAt(vertex)[0];
            continue;
        }
        // The result is clockwise of a piece that arrives, until one leaves. Twice around, as the
        // first ones may belong to the last ones.
        findEnds(vertex, pieces, vertices, ends);
        isDone.assign(ends.size(), false);
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
