// SPDX-License-Identifier: GPL-3.0-or-later
// Markers, such as arrowheads, as shapes of their own.
#include "app/formats/svg/limits.h"
#include "app/formats/svg/marker_vertices.h"
#include "app/formats/svg/page.h"
#include "app/formats/svg/scanner.h"
#include "app/formats/svg/tree_drawer.h"

#include <cmath>
#include <numbers>

namespace app::svg {
namespace {

Matrix rotation(double radians)
{
    const double s = std::sin(radians), c = std::cos(radians);
    return {c, s, -s, c, 0, 0};
}

// A paint as another element may use it: with the colour that `currentColor` means here.
Paint asContext(const Paint& paint, const Properties& p)
{
    if (paint.kind == Paint::Kind::ContextFill)
        return p.contextFill;
    if (paint.kind == Paint::Kind::ContextStroke)
        return p.contextStroke;
    return paint.kind == Paint::Kind::Current ? Paint{Paint::Kind::Solid, p.colour} : paint;
}

std::string_view referenceOf(const Properties& p, MarkerVertex::Kind kind)
{
    using Kind = MarkerVertex::Kind;
    return kind == Kind::Start ? p.markerStart : kind == Kind::End ? p.markerEnd : p.markerMid;
}

// Radians; empty: that of the path.
std::optional<double> fixedAngle(std::string_view orient)
{
    if (orient.starts_with("auto"))
        return std::nullopt;
    Scanner in(trimmed(orient));
    const auto number = in.number();
    const auto degrees = number ? degreesOf(in.rest()) : std::nullopt;
    return number && degrees ? *number * *degrees * std::numbers::pi / 180 : 0;
}

} // namespace

void setContext(Properties& to, const Properties& from)
{
    const Paint fill = asContext(from.fill, from), stroke = asContext(from.stroke, from);
    to.contextFill = fill;
    to.contextStroke = stroke;
}

bool TreeDrawer::hasMarkers(const Properties& p) const
{
    for (const auto reference : {p.markerStart, p.markerMid, p.markerEnd})
        if (isMarker(tree_.findReference(reference)))
            return true;
    return false;
}

bool TreeDrawer::isMarker(Node node) const
{
    return node != noNode && tree_.name(node) == "marker"
           && std::ranges::find(used_, node) == used_.end();
}

// `place` is that of the shape, whose markers these are.
void TreeDrawer::drawMarkers(const std::vector<MarkerVertex>& vertices, const Place& place)
{
    const Node node = node_;
    const auto line = report_.line();
    int drawn = 0;
    for (const MarkerVertex& vertex : vertices) {
        const Node marker = tree_.findReference(referenceOf(place.properties, vertex.kind));
        if (!isMarker(marker))
            continue;
        used_.push_back(marker);
        drawMarker(marker, vertex, place);
        used_.pop_back();
        ++drawn;
    }
    node_ = node;
    report_.turnTo(line);
    report_.add(losses::drawnMarker, drawn);
}

void TreeDrawer::drawMarker(Node marker, const MarkerVertex& vertex, const Place& around)
{
    node_ = marker;
    refuseTooDeep(around);
    Place place = around;
    place.properties = inheritedBy(marker);
    place.lengths.fontSize = place.properties.fontSize;
    setContext(place.properties, around.properties);
    place.repeated = true;
    place = inside(marker, place);
    place.hidden = around.hidden; // display has no effect on it
    const auto orient = trimmed(tree_.attribute(marker, "orient"));
    const bool reversed =
        orient == "auto-start-reverse" && vertex.kind == MarkerVertex::Kind::Start;
    const double angle = fixedAngle(orient.empty() ? "0" : orient)
                             .value_or(vertex.angle + (reversed ? std::numbers::pi : 0));
    const bool ofUser = tree_.attribute(marker, "markerUnits") == "userSpaceOnUse";
    const double scale = ofUser ? 1 : around.properties.width;
    place.matrix =
        around.matrix * translation(vertex.at) * rotation(angle) * Matrix{scale, 0, 0, scale, 0, 0};
    if (scale > 0 && turnToMarker(marker, place))
        drawChildren(marker, place);
}

// Turns to the coordinates of a marker's content. False: it has no size.
bool TreeDrawer::turnToMarker(Node marker, Place& place)
{
    constexpr double usualSize = 3;
    const Point around = place.lengths.viewport; // what percentages refer to, as in browsers
    const auto length = [&](std::string_view name, double whole, double usual) {
        return place.lengths.parse(tree_.attribute(marker, name), whole).value_or(usual);
    };
    const Box viewport{
        {},
        {length("markerWidth", around.x, usualSize), length("markerHeight", around.y, usualSize)}};
    if (!(viewport.size.x > 0 && viewport.size.y > 0)) {
        report_.add(losses::sizeless);
        return false;
    }
    const auto box = readViewBox(tree_, marker, report_);
    const Box content = box.value_or(Box{{}, viewport.size});
    const Matrix toViewport =
        box ? viewBoxTransform(*box, viewport, tree_.attribute(marker, "preserveAspectRatio"))
            : Matrix{};
    place.lengths.viewport = content.size;
    const auto reference = [&](std::string_view name, int axis) {
        const auto text = trimmed(tree_.attribute(marker, name));
        for (const auto& [word, share] : {std::pair{"left", 0.0},
                                          {"top", 0.0},
                                          {"center", 0.5},
                                          {"right", 1.0},
                                          {"bottom", 1.0}})
            if (equalsIgnoringCase(text, word))
                return content.min[axis] + share * content.size[axis];
        return length(name, around[axis], 0);
    };
    place.matrix =
        place.matrix * translation(-toViewport({reference("refX", 0), reference("refY", 1)}));
    Place inner = place;
    inner.matrix = place.matrix * toViewport;
    if (!place.properties.overflowShown && !fitsMarker(marker, inner, toViewport, viewport))
        addViewportClip(viewport, place);
    inner.clips = place.clips;
    place = std::move(inner);
    return true;
}

// Whether all of a marker lies in its viewport, so that nothing is to be cut.
bool TreeDrawer::fitsMarker(Node marker, const Place& place, const Matrix& toViewport,
                            const Box& viewport)
{
    const auto [at, isNew] = markersThatFit_.try_emplace(marker);
    if (isNew) {
        const auto bounds = boundsOf(marker, place, BoxOf::Stroke);
        const double slack = 1e-6 * (viewport.size.x + viewport.size.y);
        at->second = bounds.has_value();
        for (const double x : {0.0, 1.0})
            for (const double y : {0.0, 1.0}) {
                const Box box = bounds.value_or(Box());
                const Point p = toViewport(box.min + box.size * Point{x, y});
                at->second = at->second && p.x >= -slack && p.y >= -slack
                             && p.x <= viewport.size.x + slack && p.y <= viewport.size.y + slack;
            }
    }
    return at->second;
}

} // namespace app::svg
