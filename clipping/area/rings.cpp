// SPDX-License-Identifier: MIT
#include "clipping/area/vertices.h"
#include "clipping/ieee_numbers.h"

namespace clipping {
namespace {

constexpr std::size_t none = ~std::size_t(0);

/// Walks from piece to piece. Where it comes back to a point, the pieces since then are a ring.
class RingWalk {
public:
    RingWalk(std::span<const BoundaryPiece> pieces, const BoundaryVertices& vertices,
             const std::vector<std::uint32_t>& follower)
        : pieces_(pieces), vertices_(vertices), follower_(follower), isDone_(pieces.size()),
          placeOf_(vertices_.count(), none)
    {
        result_.part = AreaPart::Cut;
        result_.points.reserve(pieces.size()), result_.origins.reserve(pieces.size());
    }

    ClippedArea rings(const std::stop_token& stop) &&
    {
        for (std::uint32_t i = 0; i < pieces_.size(); ++i)
            if (stop.stop_requested())
                return {AreaPart::Stopped};
            else if (!isDone_[i])
                walkFrom(i);
        return std::move(result_);
    }

private:
    void walkFrom(std::uint32_t piece)
    {
        for (; !isDone_[piece]; piece = follower_[piece]) {
            isDone_[piece] = true;
            placeOf_[vertices_.from(piece)] = way_.size();
            way_.push_back(piece);
            if (const std::size_t begin = placeOf_[vertices_.to(piece)]; begin != none) {
                append(std::span(way_).subspan(begin));
                for (std::size_t i = begin; i < way_.size(); ++i)
                    placeOf_[vertices_.from(way_[i])] = none;
                way_.resize(begin);
            }
        }
    }

    /// Whether one piece goes on where the other one ends, and nothing else touches them there.
    bool areOne(std::uint32_t piece, std::uint32_t next) const
    {
        const BoundaryPiece &p = pieces_[piece], &q = pieces_[next];
        return p.edge == q.edge && p.isReversed == q.isReversed
               && vertices_.beginningAt(vertices_.from(next)).size() == 1;
    }

    void append(std::span<const std::uint32_t> ring)
    {
        const std::size_t first = result_.points.size();
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const BoundaryPiece& piece = pieces_[ring[i]];
            if (i > 0 && areOne(ring[i - 1], ring[i])) {
                result_.origins.back().to = piece.origin().to;
                continue;
            }
            result_.points.push_back(piece.from);
            result_.origins.push_back(piece.origin());
        }
        if (result_.points.size() > first + 1 && areOne(ring.back(), ring.front())) {
            result_.points[first] = result_.points.back();
            result_.origins[first].from = result_.origins.back().from;
            result_.points.pop_back(), result_.origins.pop_back();
        }
        if (result_.points.size() < first + 3) // empty by rounding
            result_.points.resize(first), result_.origins.resize(first);
        else
            result_.ringEnds.push_back(static_cast<std::uint32_t>(result_.points.size()));
    }

    std::span<const BoundaryPiece> pieces_;
    const BoundaryVertices& vertices_;
    const std::vector<std::uint32_t>& follower_;
    std::vector<bool> isDone_;
    std::vector<std::size_t> placeOf_; ///< for each vertex, where the way leaves it
    std::vector<std::uint32_t> way_;
    ClippedArea result_;
};

} // namespace

ClippedArea ringsOf(std::span<const BoundaryPiece> pieces, const std::stop_token& stop)
{
    const BoundaryVertices vertices(pieces, stop);
    if (stop.stop_requested())
        return {AreaPart::Stopped};
    const std::vector<std::uint32_t> follower = followers(pieces, vertices, stop);
    if (stop.stop_requested())
        return {AreaPart::Stopped};
    return RingWalk(pieces, vertices, follower).rings(stop);
}

} // namespace clipping
