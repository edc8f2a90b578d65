// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/area/boundary.h"

namespace clipping {

/// The points where pieces begin and end, numbered, and the pieces that begin there. Points are the
/// same if their rounded coordinates are. Of no use if a stop was requested.
class BoundaryVertices {
public:
    BoundaryVertices(std::span<const BoundaryPiece> pieces, const std::stop_token& stop);

    std::size_t count() const { return first_.size() - 1; }
    std::uint32_t from(std::size_t piece) const { return from_[piece]; }
    std::uint32_t to(std::size_t piece) const { return to_[piece]; }
    /// Indices of the pieces that begin at a vertex, or end there; as many of each.
    std::span<const std::uint32_t> beginningAt(std::uint32_t vertex) const
    {
        return std::span(beginning_).subspan(first_[vertex], first_[vertex + 1] - first_[vertex]);
    }
    std::span<const std::uint32_t> endingAt(std::uint32_t vertex) const
    {
        return std::span(ending_).subspan(first_[vertex], first_[vertex + 1] - first_[vertex]);
    }

private:
    std::uint32_t vertexAt(const glm::dvec2& p);
    std::vector<std::uint32_t> listedBy(const std::vector<std::uint32_t>& vertexOf,
                                        const std::stop_token& stop) const;

    std::vector<glm::dvec2> points_;   ///< of the vertices
    std::vector<std::uint32_t> table_; ///< 1 + a vertex, at its hash or after it; 0: none
    std::vector<std::uint32_t> from_, to_, first_, beginning_, ending_;
};

/// The piece that follows each piece on its ring. Where several pass one point, the one is chosen
/// that has the same part of the result beside it, so that rings do not cross. Some are missing if
/// a stop was requested.
std::vector<std::uint32_t> followers(std::span<const BoundaryPiece> pieces,
                                     const BoundaryVertices& vertices, const std::stop_token& stop);

} // namespace clipping
