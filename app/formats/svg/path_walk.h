// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/bezier.h"

#include <optional>
#include <span>
#include <vector>

namespace app::svg {

/// So fine that the chords of these paths have their length within 0.1 %, whatever their size.
double flatteningTolerance(std::span<const Subpath> paths);

/// Places along paths by their distance from the start, as text on a path and markers need them.
class PathWalk {
public:
    explicit PathWalk(std::span<const Subpath> paths);

    struct Step {
        Point at, along; ///< `along` has length 1
    };
    double length() const { return pieces_.empty() ? 0 : pieces_.back().end; }
    std::optional<Step> at(double distance) const; ///< empty beyond the ends

private:
    struct Piece { ///< a chord of a curve, or a line
        Bezier curve;
        double t0, t1;
        double end; ///< its distance from the start of all
        double length;
    };
    std::vector<Piece> pieces_;
};

} // namespace app::svg
