// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/path.h"

#include <optional>
#include <span>
#include <vector>

namespace app {

/// A freehand stroke as a path of few smooth curves: every point lies within `tolerance` (user
/// units, > 0) of it. Where the stroke turns sharply, at the scale of the tolerance, it has a
/// corner. The first and last points stay. A straight stroke becomes a line.
///
/// The curves are fitted while points are added, and only those at the end are fitted again. So
/// however long the stroke is, adding a point or asking for the path takes some milliseconds.
class Freehand {
public:
    Freehand(const Point& start, double tolerance);
    void add(const Point& point); ///< other than the last one
    Subpath path() const;         ///< after at least one point was added
    /// The same without the last fit: curves followed by lines.
    Subpath draft() const;

private:
    std::vector<Point> reduced() const;
    void fit(std::size_t before);

    double tolerance_;
    Subpath done_;
    std::optional<Point> direction_; ///< at the end of `done_`; empty: at a corner
    std::vector<Point> few_;         ///< from there on, reduced
    std::vector<Point> later_;       ///< after those, as they were added
};

/// The path of a stroke of at least two points.
Subpath smoothed(std::span<const Point> stroke, double tolerance);

} // namespace app
