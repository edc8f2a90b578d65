// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/window_outline.h"

#include "app/document/direction.h"
#include "app/document/window_frame.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app {
namespace {

using Ring = std::vector<Point>;

constexpr int mostCorners = 100'000; // of an ellipse: for a tolerance that is far too small

// The number of corners on a circle of which no edge is farther than the tolerance from its arc; a
// multiple of four, so that the outermost points are corners.
int cornersOn(double radius, double tolerance)
{
    if (!(radius > tolerance))
        return 4;
    const double half = std::acos(1 - tolerance / radius);
    const double quarter = std::ceil(std::numbers::pi / half / 4);
    return 4 * int(std::min(quarter, mostCorners / 4.0));
}

// The edges of an ellipse are those of a circle of the larger radius, moved closer together.
Ring inscribed(const EllipseRecipe& ellipse, double tolerance)
{
    const Point radii = glm::abs(ellipse.radii);
    const int count = cornersOn(std::max(radii.x, radii.y), tolerance);
    Ring ring;
    for (int i = 0; i < count; ++i)
        ring.push_back(ellipse.centre
                       + turnedBy(radii * directionOf(-360.0 * i / count), ellipse.turn));
    return ring;
}

Ring ringOf(const Subpath& path, double tolerance)
{
    std::vector<Chord> chords;
    flatten(path, tolerance, chords);
    Ring ring{path.start};
    for (const Chord& chord : chords)
        if (chord.segment.b != ring.back())
            ring.push_back(chord.segment.b);
    if (ring.size() > 1 && ring.back() == ring.front())
        ring.pop_back();
    return ring;
}

struct OutlineOfWindow {
    double tolerance;
    bool asDrawn;

    WindowOutline operator()(const RectangleShape& rectangle) const
    {
        const auto& [min, max] = rectangle.box;
        if (!(min.x <= max.x && min.y <= max.y))
            return {};
        const auto corners = cornersOf(rectangle);
        return {{{corners.begin(), corners.end()}}};
    }
    WindowOutline operator()(const PathShape& shape) const
    {
        WindowOutline outline{{}, shape.rule};
        if (const auto* ellipse = std::get_if<EllipseRecipe>(&shape.recipe); ellipse && !asDrawn)
            outline.rings.push_back(inscribed(*ellipse, tolerance));
        else
            for (const Subpath& path : shape.path.subpaths())
                outline.rings.push_back(ringOf(path, tolerance));
        return outline;
    }
};

} // namespace

WindowOutline outlineOf(const WindowShape& shape, double tolerance)
{
    return std::visit(OutlineOfWindow{tolerance, false}, shape);
}

WindowOutline drawnOutlineOf(const WindowShape& shape, double tolerance)
{
    return std::visit(OutlineOfWindow{tolerance, true}, shape);
}

const EllipseRecipe* ellipseOf(const WindowShape& shape)
{
    const auto* path = std::get_if<PathShape>(&shape);
    return path ? std::get_if<EllipseRecipe>(&path->recipe) : nullptr;
}

} // namespace app
