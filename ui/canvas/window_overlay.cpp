// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/window_overlay.h"

#include "app/document/window_operations.h"
#include "app/document/window_outline.h"
#include "app/document/window_shape.h"
#include "app/scene/area_windows.h"
#include "app/session/window_in_hand.h"
#include "app/view/frame_handles.h"
#include "app/view/window_borders.h"
#include "ui/canvas/left_alone_mark.h"
#include "ui/canvas/window_label.h"
#include "ui/canvas/window_offer.h"
#include "ui/canvas/window_tags.h"
#include "ui/widgets/swatch.h"

#include <QPainterPath>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace ui {

QRectF boxOnScreen(const app::View& view, const clipping::Window& window)
{
    const app::Point room(64), least = -room, most = view.size + room;
    const app::Point min = glm::clamp(view.toScreen(window.min), least, most);
    const app::Point max = glm::clamp(view.toScreen(window.max), least, most);
    return {QPointF(min.x, min.y), QPointF(max.x, max.y)};
}

namespace {

constexpr double usualOutline = 1.5, outlineHovered = 2.5, casing = 1; // pixels
constexpr double handleSize = 9;

QRectF boxInHand(const Controller& controller)
{
    return boxOnScreen(controller.view(), *controller.clipWindow());
}

using Rings = std::vector<std::vector<app::Point>>;

// Edge by edge, because painters fail with coordinates like 1e9.
QPainterPath clippedOutline(const app::View& view, const Rings& rings)
{
    const app::Point room(64);
    const clipping::Window visible{-room, view.size + room};
    QPainterPath path;
    for (const auto& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const clipping::Segment edge{view.toScreen(ring[i]),
                                         view.toScreen(ring[(i + 1) % ring.size()])};
            if (const auto seen = clipping::exactAlgorithm().corrected.clip(edge, visible)) {
                path.moveTo(seen->a.x, seen->a.y);
                path.lineTo(seen->b.x, seen->b.y);
            }
        }
    return path;
}

QPainterPath boxOutline(const app::View& view, const clipping::Window& box)
{
    QPainterPath path;
    path.addRect(boxOnScreen(view, box));
    return path;
}

QPainterPath ringOutline(const app::View& view, const Rings& rings)
{
    QPainterPath path;
    for (const auto& ring : rings) {
        QPolygonF polygon;
        for (const app::Point& corner : ring) {
            const app::Point at = view.toScreen(corner);
            if (!(std::abs(at.x) < 1e5 && std::abs(at.y) < 1e5))
                return clippedOutline(view, rings);
            polygon << QPointF(at.x, at.y);
        }
        path.addPolygon(polygon);
        path.closeSubpath();
    }
    return path;
}

QPainterPath outlineOnScreen(const app::View& view, const app::WindowShape& shape)
{
    if (const auto box = app::axisAlignedBox(shape))
        return boxOutline(view, *box);
    constexpr double tolerance = 0.2; // pixels
    return ringOutline(view, app::drawnOutlineOf(shape, tolerance / view.zoom).rings);
}

const app::ClipWindow& actedOn(const Controller& controller)
{
    const app::Session& session = controller.session();
    return session.windows().list[*session.windowNumber()];
}

void setDashes(QPen& pen, app::WindowOperation operation)
{
    QList<qreal> pattern;
    for (const double length : app::infoOf(operation).dashes)
        pattern << length / pen.widthF();
    if (!pattern.isEmpty())
        pen.setDashPattern(pattern);
}

/// Calls `visit(number, step)` for the windows that have an effect, and the steps of the region
/// that they are.
template <class Visit>
void forEachStep(const app::Session& session, const Visit& visit)
{
    std::size_t step = 0;
    for (const std::size_t number : app::numbersInEffect(session.windows()))
        visit(number, step++);
}

double outlineWidth(const app::Session& session, bool hovered)
{
    return (hovered ? outlineHovered : usualOutline) * (session.display().presenting ? 2 : 1);
}

/// The outline of a visible window, as it was in the frame that is shown.
QPainterPath outlineInFrame(const Controller& controller, std::size_t window, std::size_t step,
                            const app::FrameKey* shown)
{
    const app::Session& session = controller.session();
    const auto& now = session.region().steps;
    const bool moved = shown && shown->region.steps.size() == now.size()
                       && !(shown->region.steps[step] == now[step]);
    const app::ClipRegion::Step& in = moved ? shown->region.steps[step] : now[step];
    // Objects have chords, where the cut ends; only ellipses are cut more finely.
    const app::WindowShape& shape = session.windows().list[window].shape;
    if (!moved && (in.rings.empty() || app::ellipseOf(shape)))
        return outlineOnScreen(controller.view(), shape);
    return in.rings.empty() ? boxOutline(controller.view(), in.box)
                            : ringOutline(controller.view(), in.rings);
}

void paintBorder(QPainter& painter, const Controller& controller, const QPainterPath& border)
{
    const double width = outlineWidth(
        controller.session(), controller.tool().as<Hovers>().hoveredHandle() == app::Handle{});
    QPen pen(controller.pageColour(), width + 2 * casing, Qt::SolidLine, Qt::FlatCap,
             Qt::MiterJoin);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(pen);
    painter.drawPath(border);
    pen.setColor(colourOf(actedOn(controller), controller.bench()));
    pen.setWidthF(width);
    setDashes(pen, actedOn(controller).operation);
    painter.setPen(pen);
    painter.drawPath(border);
}

bool leavesAlone(const Pane& pane, std::size_t step)
{
    return std::ranges::binary_search(pane.leftAlone, step);
}

/// The outline of a window without effect: the box around one of many points, as it is no step of
/// the region, which is painted in the background.
QPainterPath quietOutline(const app::View& view, const app::WindowShape& shape)
{
    constexpr std::size_t many = 1000; // points
    const auto* own = std::get_if<app::PathShape>(&shape);
    return own && own->path.pointCount() > many ? boxOutline(view, app::boxOf(shape))
                                                : outlineOnScreen(view, shape);
}

/// Paints windows that another one replaces, except the one that is acted on.
void paintReplaced(QPainter& painter, const Controller& controller)
{
    const app::Session& session = controller.session();
    const auto& list = session.windows().list;
    const auto numbers = app::numbersInEffect(session.windows());
    painter.setPen(QPen(controller.paperLook().muted, 1));
    for (std::size_t i = 0; !numbers.empty() && i < numbers.front(); ++i)
        if (list[i].visible && i != session.windowNumber())
            painter.drawPath(quietOutline(controller.view(), list[i].shape));
}

// Paints the window that is acted on, above all others, which have thin lines.
void paintBorders(QPainter& painter, const Controller& controller, const Pane& pane,
                  const app::FrameKey* shown)
{
    const app::Session& session = controller.session();
    std::optional<QPainterPath> chosen;
    if (!app::stepInHand(session))
        chosen = quietOutline(controller.view(), actedOn(controller).shape);
    painter.setBrush(Qt::NoBrush);
    paintReplaced(painter, controller);
    forEachStep(session, [&](std::size_t number, std::size_t step) {
        if (app::isLong(session.region().steps[step]))
            return;
        if (leavesAlone(pane, step))
            return paintLeftAlone(
                painter, controller,
                outlineOnScreen(controller.view(), session.windows().list[number].shape));
        const QPainterPath outline = outlineInFrame(controller, number, step, shown);
        if (number == session.windowNumber()) {
            chosen = outline;
            return;
        }
        const app::ClipWindow& window = session.windows().list[number];
        QPen pen(colourOf(window, controller.bench()), 1);
        setDashes(pen, window.operation);
        painter.setPen(pen);
        painter.drawPath(outline);
    });
    if (chosen)
        paintBorder(painter, controller, *chosen);
}

// The line to the handle that rotates the window and, while that is hovered or dragged, the centre.
// Otherwise the centre would hide a part of the drawing.
void paintPivot(QPainter& painter, const Controller& controller, const app::WindowFrame& frame)
{
    const auto onScreen = [&](app::Handle handle) {
        const app::Point at =
            controller.view().toScreen(app::outOfFrame(frame, app::placeOf(handle, frame.box)));
        return QPointF(at.x, at.y);
    };
    if (controller.tool().as<Hovers>().hoveredHandle() == app::rotationHandle) {
        constexpr double arm = 4;
        const QPointF centre = onScreen({});
        painter.drawLine(centre - QPointF(arm, 0), centre + QPointF(arm, 0));
        painter.drawLine(centre - QPointF(0, arm), centre + QPointF(0, arm));
    }
    for (const auto& [handle, at] : app::placedHandles(frame, controller.view()))
        if (handle == app::rotationHandle)
            painter.drawLine(onScreen({0, -1}), QPointF(at.x, at.y));
}

void paintHandles(QPainter& painter, const Controller& controller)
{
    const app::WindowFrame& frame = *controller.session().windowFrame();
    const auto placed = app::placedHandles(frame, controller.view());
    const QColor colour = colourOf(actedOn(controller), controller.bench());
    painter.setPen(QPen(colour, 1));
    painter.setBrush(Qt::NoBrush);
    if (std::holds_alternative<app::PathShape>(actedOn(controller).shape)) {
        painter.setPen(QPen(colour, 1, Qt::DotLine));
        painter.drawPath(outlineOnScreen(controller.view(), frame));
    }
    painter.setPen(QPen(colour, 1));
    paintPivot(painter, controller, frame);
    painter.setPen(QPen(colour, usualOutline));
    for (const auto& [handle, at] : placed) {
        const bool hovered = controller.tool().as<Hovers>().hoveredHandle() == handle;
        painter.setBrush(hovered ? colour : controller.pageColour());
        const QRectF place(at.x - handleSize / 2 + 0.5, at.y - handleSize / 2 + 0.5, handleSize - 1,
                           handleSize - 1);
        if (handle == app::rotationHandle)
            painter.drawEllipse(place);
        else
            painter.drawRect(place);
    }
}

/// The places of the handles on screen.
std::vector<QRectF> handleBoxes(const Controller& controller)
{
    std::vector<QRectF> boxes;
    const app::WindowFrame& frame = *controller.session().windowFrame();
    for (const auto& [handle, at] : app::placedHandles(frame, controller.view()))
        boxes.push_back(
            QRectF(at.x - handleSize / 2, at.y - handleSize / 2, handleSize, handleSize));
    return boxes;
}

// Other windows of which a capsule could hide all.
void addSmallNeighbours(const Controller& controller, std::vector<QRectF>& boxes)
{
    constexpr double small = 48; // pixels
    const app::Session& session = controller.session();
    const auto& steps = session.region().steps;
    forEachStep(session, [&](std::size_t number, std::size_t step) {
        if (!app::isProper(steps[step].box)) // it contains nothing
            return;
        const QRectF box = boxOnScreen(controller.view(), steps[step].box);
        if (number != session.windowNumber() && box.width() < small && box.height() < small)
            boxes.push_back(box);
    });
}

// Whether the window has handles and a label: only in the active pane, if its outline is visible.
bool isFurnished(const Controller& controller, const Pane& pane, const QRectF& window)
{
    const QRectF seen(0, 0, controller.view().size.x, controller.view().size.y);
    return pane.active && controller.toolInfo().showsHandles() && seen.intersects(window)
           && !window.contains(seen);
}

} // namespace

std::vector<app::BorderLine> longBorders(const Workbench& bench, const Pane& pane)
{
    const app::Session& session = bench.session;
    std::vector<app::BorderLine> borders;
    forEachStep(session, [&](std::size_t number, std::size_t step) {
        if (!app::isLong(session.region().steps[step]) || leavesAlone(pane, step))
            return;
        const app::ClipWindow& window = session.windows().list[number];
        app::BorderLine line{.step = step,
                             .colour = plainColour(colourOf(window, bench)),
                             .below = plainColour(bench.look.paper),
                             .dashes = app::infoOf(window.operation).dashes};
        if (number == session.windowNumber()) {
            line.width = outlineWidth(session, false);
            line.widthBelow = line.width + 2 * casing;
        }
        borders.push_back(std::move(line));
    });
    return borders;
}

void paintWindow(QPainter& painter, const Controller& controller, const Pane& pane,
                 const app::FrameKey* shown)
{
    if (!controller.clipWindow()) {
        if (const QRectF place = offeredHandle(controller.held()); pane.active && !place.isEmpty())
            paintOffer(painter, place, controller.pointer(), controller.paperLook(),
                       controller.pageColour());
        return;
    }
    paintBorders(painter, controller, pane, shown);
    paintReasons(painter, controller, pane);
    const QRectF window = boxInHand(controller);
    if (pane.active)
        paintTags(painter, controller.held());
    if (!isFurnished(controller, pane, window))
        return;
    paintHandles(painter, controller);
    if (controller.capsulePlace().isEmpty())
        paintWindowLabel(painter, controller, window);
}

QRectF windowBox(const Controller& controller)
{
    QRectF box = boxInHand(controller);
    for (const QRectF& handle : handleBoxes(controller))
        box |= handle;
    return box;
}

std::vector<QRectF> windowMarks(const Controller& controller, const QFont& font)
{
    std::vector<QRectF> marks = handleBoxes(controller);
    for (const WindowTag& tag : windowTags(controller.held(), font))
        marks.push_back(tag.place);
    addSmallNeighbours(controller, marks);
    return marks;
}

std::vector<QRectF> windowFurniture(const Controller& controller, const Pane& pane,
                                    const QFont& font)
{
    if (!controller.clipWindow())
        return {offeredHandle(controller.held())};
    const QRectF window = boxInHand(controller);
    std::vector<QRectF> places{QRectF(window.topLeft(), QSizeF(window.width(), 0)),
                               QRectF(window.bottomLeft(), QSizeF(window.width(), 0)),
                               QRectF(window.topLeft(), QSizeF(0, window.height())),
                               QRectF(window.topRight(), QSizeF(0, window.height()))};
    for (QRectF& edge : places)
        edge.adjust(-usualOutline, -usualOutline, usualOutline, usualOutline);
    if (pane.active)
        for (const WindowTag& tag : windowTags(controller.held(), font))
            places.push_back(tag.place);
    if (!isFurnished(controller, pane, window))
        return places;
    std::ranges::copy(handleBoxes(controller), std::back_inserter(places));
    places.push_back(controller.capsulePlace().isEmpty()
                         ? windowLabelPlace(controller, window, font)
                         : controller.capsulePlace());
    return places;
}

} // namespace ui
