// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/path_walk.h"

#include "app/cut/true_curve.h"
#include "app/document/flatten.h"
#include "app/document/path.h"
#include "app/formats/svg/element_bounds.h"

#include <algorithm>
#include <cmath>

namespace app::svg {
double flatteningTolerance(std::span<const Subpath> paths)
{
    constexpr double share = 1e-4, least = 1e-300;
    ElementBounds bounds;
    for (const Subpath& path : paths)
        include(bounds, path);
    const Point size = bounds.max - bounds.min;
    return std::max({size.x, size.y, least}) * share;
}

PathWalk::PathWalk(std::span<const Subpath> paths)
{
    const double tolerance = flatteningTolerance(paths);
    double end = 0;
    for (const Subpath& path : paths) {
        std::vector<Chord> chords;
        flatten(path, tolerance, chords);
        for (const Chord& chord : chords) {
            const auto& [a, b] = chord.segment;
            const double length = std::hypot(b.x - a.x, b.y - a.y);
            if (!(length > 0))
                continue;
            end += length;
            const bool curved =
                chord.pathSegment < path.segments.size() && path.segments[chord.pathSegment].curved;
            if (curved)
                pieces_.push_back(
                    {curveOf(path, chord.pathSegment), chord.t0, chord.t1, end, length});
            else
                pieces_.push_back({{a, a, b, b}, 0, 1, end, length});
        }
    }
}

std::optional<PathWalk::Step> PathWalk::at(double distance) const
{
    if (pieces_.empty() || !(distance >= 0 && distance <= length()))
        return std::nullopt;
    const auto found = std::ranges::lower_bound(pieces_, distance, {}, &Piece::end);
    const Piece& piece = found == pieces_.end() ? pieces_.back() : *found;
    const double share = 1 - (piece.end - distance) / piece.length;
    const bool straight =
        piece.curve.from == piece.curve.control1 && piece.curve.control2 == piece.curve.to;
    const double t = piece.t0 + share * (piece.t1 - piece.t0);
    const Point chord = piece.curve.to - piece.curve.from;
    const Point at = straight ? piece.curve.from + chord * share : piece.curve.at(t);
    Point along = straight ? chord : piece.curve.slope(t);
    if (along == Point{})
        along = piece.curve.at(piece.t1) - piece.curve.at(piece.t0);
    return Step{at, along / std::hypot(along.x, along.y)};
}

} // namespace app::svg
