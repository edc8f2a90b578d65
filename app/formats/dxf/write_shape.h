// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <variant>
#include <vector>

// A path as the entity of DXF that holds it whole. All points are in a plane whose y points up.

namespace app::dxf::writing {

struct LineShape {
    Point from, to;
};
/// A circle (`sweep` is a full turn), or an arc from the angle `from`, counterclockwise, in
/// radians.
struct ArcShape {
    Point centre;
    double radius, from, sweep;
};
/// An ellipse or a part of it, counterclockwise from the parameter `from`; parameters count from
/// the end of the major axis.
struct EllipseShape {
    Point centre, majorAxis;
    double ratio; ///< of the minor axis to the major one, at most 1
    double from, sweep;
};
struct Vertex {
    Point at;
    /// Of the arc to the next vertex: the tangent of a quarter of its angle, > 0 if it is
    /// counterclockwise; 0: a line.
    double bulge = 0;
};
struct PolylineShape {
    std::vector<Vertex> vertices;
    bool closed;
};
/// Cubic Bézier curves that follow each other: every third control point is on them.
struct SplineShape {
    std::vector<Point> controls;
};
struct PointShape {
    Point at;
};
using Shape =
    std::variant<PointShape, LineShape, ArcShape, EllipseShape, PolylineShape, SplineShape>;

/// Which shapes a version of DXF has: with ellipses and splines, or only lines and arcs.
enum class Curves : std::uint8_t { All, Arcs };

/// The shape of a path, as good as the parts of its circles are: off by at most 0.05 % of their
/// radius. Its ends and vertices are those of the path. Other curves become lines within
/// `tolerance` (> 0) with Curves::Arcs.
Shape shapeOf(const Subpath& path, Curves curves, double tolerance);

/// Whether lines and arcs are all that is in a path.
bool hasOnlyArcs(const Subpath& path);

} // namespace app::dxf::writing
