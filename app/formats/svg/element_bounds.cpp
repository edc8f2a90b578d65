// SPDX-License-Identifier: GPL-3.0-or-later
// The bounding box of an element, to which its transform may refer.
#include "app/formats/svg/element_bounds.h"

#include "app/base/text.h"
#include "app/cut/stroke_rings.h"
#include "app/document/bezier.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/refused.h"
#include "app/formats/svg/tree_drawer.h"
#include "app/lettering/outline_fonts.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace app::svg {
namespace {

void include(ElementBounds& bounds, const Point& p)
{
    bounds.min = bounds.isEmpty ? p : glm::min(bounds.min, p);
    bounds.max = bounds.isEmpty ? p : glm::max(bounds.max, p);
    bounds.isEmpty = false;
}

// The points at which the curve turns back along an axis: the roots of its derivative.
void includeTurns(ElementBounds& bounds, const Bezier& curve, int axis)
{
    const double d0 = curve.control1[axis] - curve.from[axis];
    const double d1 = curve.control2[axis] - curve.control1[axis];
    const double d2 = curve.to[axis] - curve.control2[axis];
    const double a = d0 - 2 * d1 + d2, b = d1 - d0;
    const double root = std::sqrt(std::max(b * b - a * d0, 0.0));
    const double q = -(b + std::copysign(root, b)); // without cancellation
    for (const double t : {a != 0 ? q / a : -1, q != 0 ? d0 / q : -1})
        if (t > 0 && t < 1)
            include(bounds, curve.at(t));
}

// Adds what a stroke covers, without regard to dashes, beside its paths.
void addStrokes(std::vector<Subpath>& paths, const Style& style)
{
    constexpr double tolerance = 0.001; // of its width
    const std::size_t count = paths.size();
    for (std::size_t i = 0; i < count && style.width > 0; ++i)
        for (Subpath& ring : strokeRings(paths[i], style, tolerance * style.width))
            paths.push_back(std::move(ring));
}

} // namespace

void include(ElementBounds& bounds, const Subpath& path)
{
    Point from = path.start;
    include(bounds, from);
    for (const PathSegment& segment : path.segments) {
        include(bounds, segment.to);
        for (int axis = 0; segment.curved && axis < 2; ++axis)
            includeTurns(bounds, {from, segment.control1, segment.control2, segment.to}, axis);
        from = segment.to;
    }
}

std::optional<Box> TreeDrawer::boundsOf(Node node, const Place& place, BoxOf of)
{
    const Report::Silence silence(report_);
    Place own = place;
    own.matrix = {};
    ElementBounds bounds{.ofStrokes = of == BoxOf::Stroke};
    addBounds(node, own, bounds);
    if (!bounds.isKnown)
        return std::nullopt;
    return bounds.isEmpty ? Box{} : Box{bounds.min, bounds.max - bounds.min};
}

// `place` is that of the element's content.
void TreeDrawer::addBounds(Node node, const Place& place, ElementBounds& bounds)
{
    if (++bounded_ > mostBounded)
        throw Refused{Text::tr("exceeds the limit of %1 elements in the bounding boxes that "
                               "transforms and clip paths refer to.")
                          .arg(mostBounded)};
    const auto name = tree_.name(node);
    if (const OutlineKind* kind = findOutlineKind(name)) {
        Outline outline = outlineOf(*kind, node, place);
        if (bounds.ofStrokes && place.properties.stroke.kind != Paint::Kind::None)
            addStrokes(outline.paths, paints_.style(place.properties, 1, {}));
        for (const Subpath& path : placed(std::move(outline), place.matrix))
            include(bounds, path);
    } else if (name == "g" || name == "a" || name == "marker") {
        addBoundsOfChildren(node, place, bounds);
    } else if (name == "svg") {
        if (const auto viewport = inViewport(node, place, {}))
            addBoundsOfChildren(node, *viewport, bounds);
    } else if (name == "switch") {
        if (const Node chosen = chosenOf(node); chosen != noNode)
            addBoundsWithin(chosen, place, bounds);
    } else if (name == "use") {
        addBoundsOfUse(node, place, bounds);
    } else if (name == "text" && !outlineFonts().isEmpty()) {
        addBoundsOfText(node, place, bounds);
    } else if (const auto box = name == "image" ? imageBox(node, place) : std::nullopt) {
        for (const Subpath& path : rectangleShape(*box, place.matrix).path.subpaths())
            include(bounds, path);
    } else if (isDrawn(name)) {
        bounds.isKnown = false;
    }
}

void TreeDrawer::addBoundsOfChildren(Node node, const Place& place, ElementBounds& bounds)
{
    for (const Node child : Children(tree_, node))
        addBoundsWithin(child, place, bounds);
}

void TreeDrawer::addBoundsOfUse(Node use, const Place& place, ElementBounds& bounds)
{
    const Node target = tree_.findReference(hrefOf(tree_, use));
    if (target == noNode || containsItself(use, target))
        return;
    Place shifted = place;
    shifted.matrix = place.matrix * translation(shiftOf(use, place));
    used_.push_back(target);
    const auto name = tree_.name(target);
    if (name != "symbol" && name != "svg")
        addBoundsWithin(target, shifted, bounds);
    else if (const auto viewport = inViewport(target, styled(target, shifted), sizeOf(use, place)))
        addBoundsOfChildren(target, *viewport, bounds);
    used_.pop_back();
}

void TreeDrawer::addBoundsWithin(Node node, const Place& around, ElementBounds& bounds)
{
    if (around.depth > deepestNesting || !isDrawn(tree_.name(node)) || !isWanted(node))
        return;
    const Place place = styled(node, around);
    if (place.properties.displayed)
        addBounds(node, place, bounds);
}

} // namespace app::svg
