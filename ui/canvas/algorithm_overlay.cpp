// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/algorithm_overlay.h"

#include "app/overlays/label_places.h"
#include "ui/canvas/overlay_boxes.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>

namespace ui {
namespace {

using app::Emphasis;
using app::OverlayArea;
using app::OverlayLine;
using app::OverlayMark;

constexpr double hatchSpacing = 9, tickSpacing = 9, tick = 6; // pixels
constexpr double markRadius = 4, signRadius = 8, besideMark = 6;

class Painting {
public:
    Painting(QPainter& painter, const OverlayGround& ground, const QFont& font,
             std::vector<QRectF> taken)
        : painter_(painter), ground_(ground), font_(font),
          places_(ground.room, std::move(taken), ground.avoided)
    {
    }

    void area(const OverlayArea& area)
    {
        const QPolygonF polygon = onScreen(area.corners);
        if (area.ground == OverlayArea::Ground::Hatched) {
            painter_.setPen(QPen(faint(ground_.look.muted, 0.3F), 1));
            for (const QLineF& line : app::hatching(polygon, hatchSpacing))
                painter_.drawLine(line);
        }
        painter_.setPen(Qt::NoPen);
        painter_.setBrush(
            faint(ground_.look.selection, area.emphasis == Emphasis::Highlighted ? 0.14F : 0.07F));
        if (area.pointed || area.emphasis == Emphasis::Highlighted)
            painter_.drawPolygon(polygon);
    }

    void line(const OverlayLine& line)
    {
        const QLineF seen(ground_.onScreen(line.segment.a), ground_.onScreen(line.segment.b));
        painter_.setPen(penOf(line));
        painter_.drawLine(seen);
        if (line.outwards != app::Point(0, 0))
            outerSide(seen, line);
        if (line.kind == OverlayLine::Kind::Move)
            arrow(seen);
    }

    void mark(const OverlayMark& mark)
    {
        const QPointF at = ground_.onScreen(mark.at);
        if (!ground_.room.contains(at))
            return;
        const QColor colour = colourOf(mark.emphasis);
        painter_.setPen(QPen(colour, 1.5));
        painter_.setBrush(mark.symbol == OverlayMark::Symbol::Filled
                                  || mark.symbol == OverlayMark::Symbol::Diamond
                              ? colour
                              : ground_.page);
        paintSymbol(mark.symbol, at);
        const double radius =
            mark.symbol == OverlayMark::Symbol::Plus || mark.symbol == OverlayMark::Symbol::Minus
                ? signRadius
                : markRadius;
        places_.take(QRectF(at.x() - radius, at.y() - radius, 2 * radius, 2 * radius));
    }

    void labelOf(const OverlayMark& mark)
    {
        const QPointF at = ground_.onScreen(mark.at);
        const QSizeF size = sizeOf(mark.label);
        if (!mark.label.isEmpty() && ground_.room.contains(at))
            if (const auto place = places_.first(app::placesBeside(at, size, besideMark)))
                text(*place, mark.label, mark.emphasis);
    }
    void labelOf(const OverlayLine& line)
    {
        const QLineF seen(ground_.onScreen(line.segment.a), ground_.onScreen(line.segment.b));
        if (!line.label.isEmpty())
            if (const auto place = places_.first(app::placesAlong(seen, sizeOf(line.label), 3)))
                text(*place, line.label, line.emphasis);
    }
    void labelOf(const OverlayArea& area)
    {
        if (area.label.isEmpty() || area.corners.empty())
            return;
        const QSizeF size = sizeOf(area.label);
        if (const auto place = places_.first(app::placesInside(onScreen(area.corners), size)))
            area.strong == 0 ? text(*place, area.label, labelEmphasis(area)) : code(*place, area);
    }
    /// The order in which areas get their labels: 0 is first.
    static int rank(const OverlayArea& area)
    {
        return area.pointed ? 0 : area.emphasis == Emphasis::Highlighted ? 1 : 2;
    }

private:
    static QColor faint(QColor colour, float alpha)
    {
        colour.setAlphaF(alpha);
        return colour;
    }
    QPolygonF onScreen(const std::vector<app::Point>& corners) const
    {
        QPolygonF polygon;
        for (const app::Point& corner : corners)
            polygon << ground_.onScreen(corner);
        return polygon;
    }
    QColor colourOf(Emphasis emphasis) const
    {
        return emphasis == Emphasis::Quiet ? ground_.look.muted : ground_.look.selection;
    }
    QPen penOf(const OverlayLine& line) const
    {
        const bool highlighted = line.emphasis == Emphasis::Highlighted;
        QPen pen(colourOf(line.emphasis), highlighted ? 1.5 : 1, Qt::SolidLine, Qt::FlatCap);
        if (line.kind == OverlayLine::Kind::Border && !highlighted)
            pen.setDashPattern({4, 4});
        if (line.kind == OverlayLine::Kind::Ray)
            pen.setDashPattern({8, 3, 2, 3});
        return pen;
    }

    // Paints short strokes on the side that is not kept.
    void outerSide(const QLineF& seen, const OverlayLine& line)
    {
        const app::Point middle = (line.segment.a + line.segment.b) / 2.0;
        const double far = glm::distance(line.segment.a, line.segment.b);
        const QPointF side =
            ground_.onScreen(middle + far * line.outwards) - ground_.onScreen(middle);
        const double length = seen.length(), size = std::hypot(side.x(), side.y());
        if (!(length >= 1 && size > 0))
            return;
        const QPointF along = (seen.p2() - seen.p1()) / length;
        const QPointF stroke = (side / size + along) * tick;
        painter_.setPen(QPen(faint(colourOf(line.emphasis), 0.6F), 1));
        const auto ticks = int(std::ceil(length / tickSpacing - 0.5));
        for (int i = 0; i < ticks; ++i) {
            const QPointF from = seen.p1() + (i + 0.5) * tickSpacing * along;
            painter_.drawLine(QLineF(from, from + stroke));
        }
    }

    void arrow(const QLineF& seen)
    {
        if (seen.length() < 24)
            return;
        const QPointF along = (seen.p2() - seen.p1()) / seen.length(), aside(-along.y(), along.x());
        const QPointF tip = seen.pointAt(0.5) + 4 * along;
        painter_.drawPolyline(
            QPolygonF{tip - 8 * along + 4 * aside, tip, tip - 8 * along - 4 * aside});
    }

    void paintSymbol(OverlayMark::Symbol symbol, const QPointF& at)
    {
        using Symbol = OverlayMark::Symbol;
        if (symbol == Symbol::Diamond) {
            painter_.drawPolygon(QPolygonF{at + QPointF(0, -5), at + QPointF(5, 0),
                                           at + QPointF(0, 5), at + QPointF(-5, 0)});
            return;
        }
        const bool sign = symbol == Symbol::Plus || symbol == Symbol::Minus;
        const double radius = sign ? signRadius : markRadius;
        painter_.drawEllipse(at, radius, radius);
        if (sign)
            painter_.drawLine(QLineF(at - QPointF(4, 0), at + QPointF(4, 0)));
        if (symbol == Symbol::Plus)
            painter_.drawLine(QLineF(at - QPointF(0, 4), at + QPointF(0, 4)));
    }

    static Emphasis labelEmphasis(const OverlayArea& area)
    {
        return area.pointed ? Emphasis::Highlighted : area.emphasis;
    }
    QSizeF sizeOf(const QString& label) const
    {
        const QFontMetricsF metrics(semiBold(font_));
        return {std::ceil(metrics.horizontalAdvance(label)) + 10, std::ceil(metrics.height()) + 2};
    }
    void base(const QRectF& place, Emphasis emphasis)
    {
        painter_.setPen(Qt::NoPen);
        painter_.setBrush(emphasis == Emphasis::Quiet ? faint(ground_.page, 0.88F)
                                                      : ground_.look.tint);
        painter_.drawRoundedRect(place, space::radius, space::radius);
    }
    void text(const QRectF& place, const QString& words, Emphasis emphasis)
    {
        base(place, emphasis);
        const bool quiet = emphasis == Emphasis::Quiet;
        painter_.setFont(quiet ? font_ : semiBold(font_));
        painter_.setPen(quiet ? ground_.look.muted : ground_.look.text);
        painter_.drawText(place, Qt::AlignCenter, words);
    }
    // Paints an outcode character by character: emphasised ones are strong and, if hovered, blue.
    void code(const QRectF& place, const OverlayArea& area)
    {
        base(place, labelEmphasis(area));
        const QFontMetricsF metrics(semiBold(font_));
        const double step = metrics.horizontalAdvance(QLatin1Char('0'));
        QRectF cell(0, place.top(), step, place.height());
        cell.moveLeft(place.center().x() - step * double(area.label.size()) / 2);
        for (qsizetype i = 0; i < area.label.size(); ++i, cell.translate(step, 0)) {
            const bool strong = area.strong >> i & 1U;
            const bool highlighted = strong && labelEmphasis(area) == Emphasis::Highlighted;
            painter_.setFont(strong ? semiBold(font_) : font_);
            painter_.setPen(highlighted ? ground_.look.selection
                            : strong    ? ground_.look.text
                                        : ground_.look.muted);
            painter_.drawText(cell, Qt::AlignCenter, QString(area.label[i]));
        }
    }

    QPainter& painter_;
    const OverlayGround& ground_;
    QFont font_;
    app::LabelPlaces places_;
};

} // namespace

void paintAlgorithmOverlay(QPainter& painter, const app::Overlay& overlay,
                           const OverlayGround& ground)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const QFont font = captionFont(painter.font());
    painter.setFont(font);
    std::vector<QRectF> taken = ground.taken;
    const OverlayBoxes boxes = boxesOf(overlay, ground, font);
    for (const QRectF& box : boxes.all())
        taken.push_back(box);
    Painting painting(painter, ground, font, std::move(taken));
    for (const OverlayArea& area : overlay.areas)
        painting.area(area);
    for (const OverlayLine& line : overlay.lines)
        painting.line(line);
    for (const OverlayMark& mark : overlay.marks)
        painting.mark(mark);
    for (const OverlayMark& mark : overlay.marks)
        painting.labelOf(mark);
    for (const int rank : {0, 1, 2})
        for (const OverlayArea& area : overlay.areas)
            if (Painting::rank(area) == rank)
                painting.labelOf(area);
    for (const OverlayLine& line : overlay.lines)
        painting.labelOf(line);
    painter.setFont(font);
    paintBoxes(painter, overlay, ground, boxes);
    painter.restore();
}

} // namespace ui
