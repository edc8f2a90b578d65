// SPDX-License-Identifier: MIT
#include "clipping/area/vertices.h"

#include "clipping/ieee_numbers.h"

#include <bit>
#include <cassert>

namespace clipping {
namespace {

std::size_t hashOf(const glm::dvec2& p)
{
    const auto x = std::bit_cast<std::uint64_t>(p.x), y = std::bit_cast<std::uint64_t>(p.y);
    // Multiplied by 2^64 / golden ratio, so that all bits reach the upper ones.
    const std::uint64_t mixed = (x * 0x9e3779b97f4a7c15u ^ std::rotl(y, 32)) * 0x9e3779b97f4a7c15u;
    return mixed ^ mixed >> 32;
}

} // namespace

BoundaryVertices::BoundaryVertices(std::span<const BoundaryPiece> pieces,
                                   const std::stop_token& stop)
    : table_(std::bit_ceil(2 * pieces.size() + 1)), from_(pieces.size()), to_(pieces.size())
{
    for (std::size_t i = 0; i < pieces.size() && !isStopped(stop, i); ++i)
        from_[i] = vertexAt(pieces[i].from);
    for (std::size_t i = 0; i < pieces.size() && !isStopped(stop, i);
         ++i) // the next one often begins where one ends
        to_[i] = i + 1 < pieces.size() && pieces[i + 1].from == pieces[i].to
                     ? from_[i + 1]
                     : vertexAt(pieces[i].to);
    if (stop.stop_requested())
        return;
    first_.assign(points_.size() + 1, 0);
    for (const std::uint32_t vertex : from_)
        ++first_[vertex + 1];
    for (std::size_t i = 1; i < first_.size(); ++i)
        first_[i] += first_[i - 1];
    beginning_ = listedBy(from_, stop), ending_ = listedBy(to_, stop);
}

std::uint32_t BoundaryVertices::vertexAt(const glm::dvec2& p)
{
    const std::size_t mask = table_.size() - 1;
    std::size_t slot = hashOf(p) & mask;
    for (; table_[slot] != 0; slot = (slot + 1) & mask)
        if (points_[table_[slot] - 1] == p)
            return table_[slot] - 1;
    points_.push_back(p);
    table_[slot] = static_cast<std::uint32_t>(points_.size());
    return table_[slot] - 1;
}

/// The pieces ordered by a vertex of theirs.
std::vector<std::uint32_t> BoundaryVertices::listedBy(const std::vector<std::uint32_t>& vertexOf,
                                                      const std::stop_token& stop) const
{
    std::vector<std::uint32_t> listed(vertexOf.size()), next(first_.begin(), first_.end() - 1);
    for (std::uint32_t i = 0; i < vertexOf.size() && !isStopped(stop, i); ++i) {
        assert(next[vertexOf[i]] < first_[vertexOf[i] + 1]);
        listed[next[vertexOf[i]]++] = i;
    }
    return listed;
}

} // namespace clipping
