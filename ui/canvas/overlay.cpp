// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/overlay.h"

#include "app/session/window_in_hand.h"
#include "app/teaching/overlay_of.h"
#include "ui/canvas/algorithm_overlay.h"
#include "ui/canvas/difference_overlay.h"
#include "ui/canvas/grid_paint.h"
#include "ui/canvas/group_overlay.h"
#include "ui/canvas/margin_paint.h"
#include "ui/canvas/snap_marker.h"
#include "ui/canvas/window_overlay.h"
#include "ui/look/checker.h"
#include "ui/tools/end_drag.h"
#include "ui/tools/transform_gesture.h"

#include <glm/common.hpp>

#include <cmath>

namespace ui {
namespace {

using clipping::Segment;

constexpr double cutMark = 7; // pixels to each side

// A segment in screen coordinates, clipped to the visible range.
std::optional<QLineF> lineOnScreen(const Controller& controller, const Segment& segment)
{
    static const auto clip = clipping::algorithms().front().corrected.clip;
    const app::View& view = controller.view();
    const double room = 64 / view.zoom;
    const clipping::Window seen = view.visible();
    const auto visible = clip(segment, {seen.min - room, seen.max + room});
    if (!visible)
        return std::nullopt;
    return QLineF(controller.bench().onScreen(visible->a), controller.bench().onScreen(visible->b));
}

void drawLine(QPainter& painter, const Controller& controller, const Segment& segment,
              const QPen& pen)
{
    painter.setPen(pen);
    if (const auto line = lineOnScreen(controller, segment))
        painter.drawLine(*line);
}

void paintHovered(QPainter& painter, const Controller& controller)
{
    const auto hovered = controller.tool().as<Hovers>().hoveredSegment();
    const app::SceneLines& lines = controller.session().scene.lines();
    if (!hovered || *hovered >= lines.size())
        return;
    drawLine(painter, controller, lines[*hovered],
             QPen(controller.paperLook().selection, 1.5, Qt::SolidLine, Qt::RoundCap));
    paintHoveredGroup(painter, controller, *hovered);
}

void paintHandle(QPainter& painter, const Controller& controller, const app::Point& screen)
{
    painter.setPen(QPen(controller.paperLook().selection, 1.5));
    painter.setBrush(controller.pageColour());
    painter.drawEllipse(QPointF(screen.x, screen.y), 4, 4);
}

/// A stroke across the line where it is cut: unlike a handle, it cannot be dragged.
void paintCut(QPainter& painter, const Controller& controller, const Segment& line,
              const app::Point& cut)
{
    const QPointF at = controller.bench().onScreen(cut);
    const QLineF along(controller.bench().onScreen(line.a), controller.bench().onScreen(line.b));
    if (along.length() == 0)
        return;
    const QPointF aside = QPointF(-along.dy(), along.dx()) / along.length() * cutMark;
    painter.setPen(QPen(controller.paperLook().selection, 2, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(at - aside, at + aside);
}

/// What is left of a line without its visible part, if it has one.
std::vector<Segment> removedParts(const Segment& whole, const clipping::Clipped* visible)
{
    if (!visible)
        return {whole};
    std::vector<Segment> parts;
    if (clipping::cutEdgeOfA(visible->cut) != clipping::Edge::NoEdge)
        parts.push_back({whole.a, visible->segment.a});
    if (clipping::cutEdgeOfB(visible->cut) != clipping::Edge::NoEdge)
        parts.push_back({visible->segment.b, whole.b});
    return parts;
}

/// The width of the stroke of a line of the drawing, in logical pixels.
double strokeWidth(const Controller& controller, std::size_t line)
{
    const app::Session& session = controller.session();
    const std::size_t object = session.scene.lines().objectOf(line);
    const double factor = session.display().presenting ? 2 : 1;
    return session.now().objects()[object].style().width * controller.view().zoom * factor;
}

// The line keeps its own colour between two lines.
void paintFrame(QPainter& painter, const QLineF& line, double stroke, const QColor& blue)
{
    const double length = line.length();
    if (length == 0)
        return;
    const QPointF aside =
        QPointF(-line.dy(), line.dx()) / length * (0.5 * std::max(1.0, stroke) + 2.5);
    painter.setPen(QPen(blue, 2));
    painter.drawLine(line.translated(aside));
    painter.drawLine(line.translated(-aside));
}

// Paints the inspected line: its visible part strong, the rest dashed.
void paintInspected(QPainter& painter, const Controller& controller, const Pane& pane)
{
    const app::Session& session = controller.session();
    if (!session.inspected())
        return;
    const Segment whole = session.scene.lines()[*session.inspected()];
    clipping::Clipped piece[1];
    const Segment one[1]{whole};
    const bool visible =
        app::clipAll(pane.choice, std::span(one), session.window(), std::span(piece)) == 1;
    const QColor blue = controller.paperLook().selection;
    QPen dashed(blue, 1.75, Qt::CustomDashLine, Qt::FlatCap);
    dashed.setDashPattern({5 / 1.75, 4 / 1.75});
    for (const Segment& removed : removedParts(whole, visible ? piece : nullptr))
        drawLine(painter, controller, removed, dashed);
    const auto seen = visible ? lineOnScreen(controller, piece[0].segment) : std::nullopt;
    if (seen)
        paintFrame(painter, *seen, strokeWidth(controller, *session.inspected()), blue);
    if (visible && clipping::cutEdgeOfA(piece[0].cut) != clipping::Edge::NoEdge)
        paintCut(painter, controller, whole, piece[0].segment.a);
    if (visible && clipping::cutEdgeOfB(piece[0].cut) != clipping::Edge::NoEdge)
        paintCut(painter, controller, whole, piece[0].segment.b);
}

void paintEnds(QPainter& painter, const Controller& controller)
{
    if (lineWithHandles(controller.session()) && controller.toolInfo().arranges())
        for (const app::Point& end : EndDrag::handles(controller.bench()))
            paintHandle(painter, controller, end);
}

// A box around many selected objects, which are not outlined one by one; for every tool.
void paintSelectionBounds(QPainter& painter, const Controller& controller)
{
    const app::Session& session = controller.session();
    if (app::outlines(session.scene.lines(), session.selection().ranges()))
        return;
    const auto& box = session.selectionBounds();
    if (!box)
        return;
    painter.setPen(QPen(controller.paperLook().selection, 1));
    painter.setBrush(Qt::NoBrush);
    const app::View& view = controller.view();
    const app::Point min = glm::clamp(view.toScreen(box->min), app::Point(-2), view.size + 2.0);
    const app::Point max = glm::clamp(view.toScreen(box->max), app::Point(-2), view.size + 2.0);
    painter.drawRect(QRectF(QPointF(min.x, min.y), QPointF(max.x, max.y)));
}

} // namespace

void paintPaper(QPainter& painter, const Controller& controller)
{
    const app::View& view = controller.view();
    const auto page = controller.session().now().page().rectangle();
    const app::Point least(-2), most = view.size + 2.0;
    const app::Point min = glm::clamp(view.toScreen(page.min), least, most);
    const app::Point max = glm::clamp(view.toScreen(page.max), least, most);
    const double ratio = painter.device()->devicePixelRatioF(), pixel = 1 / ratio;
    const auto snapped = [&](double v) { return std::round(v * ratio) / ratio; };
    const QRectF sheet(QPointF(snapped(min.x), snapped(min.y)),
                       QPointF(snapped(max.x), snapped(max.y)));
    painter.fillRect(QRectF(0, 0, view.size.x, view.size.y), controller.paperLook().canvas);
    painter.fillRect(sheet.adjusted(-pixel, -pixel, pixel, pixel), controller.paperLook().border);
    const Look& look = controller.paperLook();
    const int alpha = controller.session().now().page().background.colour.alpha;
    if (alpha < 255)
        painter.fillRect(sheet, look.paper); // which a translucent background lets through
    painter.fillRect(sheet, alpha == 0 && !look.dark ? checkerOf(look) : controller.pageColour());
    paintMargins(painter, controller);
    paintGrid(painter, controller);
    if (const app::Guides* guides = controller.bench().guides())
        for (const app::Guide& guide : guides->list)
            paintGuide(painter, controller.bench(), guide, pixel);
}

void paintOverlay(QPainter& painter, const Controller& controller, const Pane& pane,
                  const app::FrameKey* shown)
{
    painter.setRenderHint(QPainter::Antialiasing);
    paintEnteredGroup(painter, controller);
    paintSelectionBounds(painter, controller);
    paintHovered(painter, controller);
    paintInspected(painter, controller, pane);
    paintEnds(painter, controller);
    paintCopies(painter, controller.bench(), controller.session().preview().copies);
    if (controller.session().display().overlay)
        paintWhatIsSeen(painter, controller, pane);
    painter.save();
    paintDifferenceLabel(painter, controller, pane);
    painter.restore();
    painter.save();
    paintWindow(painter, controller, pane, shown);
    painter.restore();
    painter.save();
    controller.tool().paint(painter, controller.bench());
    if (controller.pointing().guide().going())
        controller.pointing().guide().paint(painter, controller.bench());
    painter.restore();
    if (pane.active)
        paintSnapMarker(painter, controller);
}

namespace {

std::optional<clipping::Segment> lineLookedAt(const Controller& controller)
{
    if (const auto& drawn = controller.session().preview().line)
        return drawn;
    const app::SceneLines& lines = controller.session().scene.lines();
    for (const auto& index :
         {controller.session().inspected(), controller.tool().as<Hovers>().hoveredSegment()})
        if (index && *index < lines.size())
            return lines[*index];
    return std::nullopt;
}

app::OverlaySubject subjectOf(const Controller& controller, const Pane& pane)
{
    const app::TracedWindow window = app::tracedWindow(controller.session());
    app::OverlaySubject subject{.variant = pane.choice,
                                .window = window.frame.box,
                                .line = lineLookedAt(controller),
                                .seen = controller.view().visible(),
                                .y = app::YAxis::Down,
                                .angle = window.frame.angle,
                                .corners = window.corners};
    if (controller.pointer())
        subject.pointer = controller.pointer()->position;
    return subject;
}

} // namespace

void paintWhatIsSeen(QPainter& painter, const Controller& controller, const Pane& pane)
{
    const app::Point size = controller.view().size;
    const QRectF room(0, 0, size.x, size.y - differenceLabelHeight(controller, pane));
    paintAlgorithmOverlay(
        painter, app::overlayOf(subjectOf(controller, pane)),
        {.room = room,
         .onScreen = [&](const app::Point& p) { return controller.bench().onScreen(p); },
         .look = controller.paperLook(),
         .page = controller.pageColour(),
         .taken = windowFurniture(controller, pane, painter.font()),
         .avoided = controller.frames().textBoxes()});
}

} // namespace ui
