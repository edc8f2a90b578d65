// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/snap_marker.h"

#include "app/base/numbers.h"
#include "app/view/snapping/marker_place.h"

#include <glm/common.hpp>

namespace ui {
namespace {

constexpr double ring = 10, glyph = 9, room = 6, leastLabelHeight = 20, gapHeight = 18; // pixels

void paintGlyph(QPainter& painter, const app::SnapKind& kind, const QRectF& square)
{
    const auto at = [&](const app::Point& p) {
        return square.center() + QPointF(p.x * square.width() / 2, p.y * square.height() / 2);
    };
    for (const auto& stroke : kind.glyph)
        painter.drawLine(at(stroke.a), at(stroke.b));
}

QSizeF labelSize(const QPainter& painter, const QString& word)
{
    const QFontMetricsF metrics(painter.font());
    return {room + glyph + room + metrics.horizontalAdvance(word) + room,
            std::max(leastLabelHeight, metrics.height() + 2)};
}

void paintSnapLabel(QPainter& painter, const Look& look, const app::Snap& snap, const QRectF& place)
{
    painter.setPen(Qt::NoPen);
    painter.setBrush(look.guideGround);
    painter.drawRoundedRect(place, space::radius, space::radius);
    QRectF square(0, 0, glyph, glyph);
    square.moveCenter({place.left() + room + glyph / 2, place.center().y()});
    painter.setPen(QPen(look.guide, 1.25, Qt::SolidLine, Qt::RoundCap));
    paintGlyph(painter, *snap.kind, square);
    painter.setPen(look.guide);
    painter.drawText(place.adjusted(2 * room + glyph, 0, -room, 0), Qt::AlignCenter, snap.word());
}

void paintPlace(QPainter& painter, const Controller& controller, const app::Snap& snap)
{
    const Look& look = controller.paperLook();
    const QPointF at = controller.bench().onScreen(snap.point);
    painter.setBrush(controller.pageColour());
    painter.setPen(QPen(look.guide, 1.75));
    painter.drawEllipse(at, ring / 2, ring / 2);
    const app::Point canvas = controller.view().size;
    paintSnapLabel(painter, look, snap,
                   app::markerPlace(at, labelSize(painter, snap.word()), {canvas.x, canvas.y},
                                    controller.typing().place));
}

app::Point pointOn(const app::AlignmentLine& line, double along)
{
    return line.axis == 0 ? app::Point(line.at, along) : app::Point(along, line.at);
}

/// Painters fail with coordinates like 1e9.
QPointF onScreen(const Controller& controller, const app::Point& point)
{
    const app::Point margin(64), size = controller.view().size;
    const app::Point at = glm::clamp(controller.view().toScreen(point), -margin, size + margin);
    return {at.x, at.y};
}

void paintGap(QPainter& painter, const Controller& controller, const app::AlignmentLine& line)
{
    const app::Session& session = controller.session();
    const double gap = *line.gapTo - *line.gapFrom;
    const QString text =
        app::lengthText(gap, session.display().unit, session.now().page().realMillimetresPerUnit());
    const QFontMetricsF metrics(painter.font());
    QRectF place(0, 0, metrics.horizontalAdvance(text) + 2 * room, gapHeight);
    place.moveCenter((onScreen(controller, pointOn(line, *line.gapFrom))
                      + onScreen(controller, pointOn(line, *line.gapTo)))
                     / 2);
    const bool fits = controller.bench().view.zoom * gap
                      > (line.axis == 0 ? 3 * gapHeight : place.width() + 2 * gapHeight);
    if (!fits || place.intersects(controller.typing().place))
        return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(controller.paperLook().guideGround);
    painter.drawRoundedRect(place, space::radius, space::radius);
    painter.setPen(controller.paperLook().guide);
    painter.drawText(place, Qt::AlignCenter, text);
}

void paintAlignment(QPainter& painter, const Controller& controller, const app::AlignmentLine& line)
{
    QPen pen(controller.paperLook().guide, 1, Qt::CustomDashLine, Qt::FlatCap);
    pen.setDashPattern({4, 3});
    painter.setPen(pen);
    painter.drawLine(onScreen(controller, pointOn(line, line.from)),
                     onScreen(controller, pointOn(line, line.to)));
    if (line.gapFrom && line.gapTo)
        paintGap(painter, controller, line);
}

} // namespace

void paintSnapMarker(QPainter& painter, const Controller& controller)
{
    const app::MovedSnap* moved = controller.tool().as<Snaps>().snapped();
    const auto& place = moved ? moved->place : controller.aim().snapped();
    if (!moved && (!place || !controller.pointer()))
        return;
    for (const app::AlignmentLine& line : moved ? moved->lines : place->lines)
        paintAlignment(painter, controller, line);
    if (place)
        paintPlace(painter, controller, *place);
}

} // namespace ui
