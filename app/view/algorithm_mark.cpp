// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/algorithm_mark.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace app {

namespace {

/// A figure around (0, 0) that fits into the circle of radius 1.
QPainterPath star(int points, double inner, double turn)
{
    QPolygonF corners;
    for (int i = 0; i < 2 * points; ++i) {
        const double angle = turn + std::numbers::pi * i / points;
        const double radius = i % 2 == 0 ? 1 : inner;
        corners << QPointF(radius * std::sin(angle), -radius * std::cos(angle));
    }
    QPainterPath path;
    path.addPolygon(corners);
    path.closeSubpath();
    return path;
}

QPainterPath polygon(int corners, double turn)
{
    return star(corners, std::cos(std::numbers::pi / corners), turn);
}

QPainterPath disc()
{
    QPainterPath path;
    path.addEllipse(QPointF(), 0.9, 0.9);
    return path;
}

QPainterPath cross(double turn)
{
    QPainterPath one, other;
    one.addRect(-0.32, -0.95, 0.64, 1.9);
    other.addRect(-0.95, -0.32, 1.9, 0.64);
    return QTransform().rotate(turn).map(one.united(other)).simplified();
}

/// A gate with a round top.
QPainterPath arch()
{
    QPainterPath path;
    path.moveTo(-0.9, 0.85);
    path.lineTo(-0.9, 0);
    path.arcTo(-0.9, -0.9, 1.8, 1.8, 180, -180);
    path.lineTo(0.9, 0.85);
    path.lineTo(0.36, 0.85);
    path.lineTo(0.36, 0);
    path.arcTo(-0.36, -0.36, 0.72, 0.72, 0, 180);
    path.lineTo(-0.36, 0.85);
    path.closeSubpath();
    return path;
}

QPainterPath bar()
{
    QPainterPath path;
    path.addRect(-0.95, -0.4, 1.9, 0.8);
    return path;
}

struct Mark {
    std::string_view abbreviation;
    QRgb light, dark;
    QPainterPath path;
};

const Mark& markOf(const clipping::Algorithm& algorithm)
{
    constexpr double half = std::numbers::pi;
    static const std::array marks{
        Mark{"EX", 0x202117, 0xFCF9FC, star(5, 0.42, 0)},
        Mark{"EX one by one", 0x6B6E66, 0xA9ABA4, star(4, 0.42, 0)}, // of experiments
        Mark{"CS", 0x091C86, 0x8194FF, disc()},
        Mark{"LB", 0x1793D8, 0x65D7FE, polygon(4, half / 4)},
        Mark{"CB", 0x005756, 0x0EC676, polygon(4, 0)},
        Mark{"NLN", 0x4C965C, 0xB6FD88, polygon(3, 0)},
        Mark{"Skala", 0xB07A00, 0xCAD30E, polygon(3, half)},
        Mark{"KWC", 0x965C87, 0xFFA3BB, cross(0)},
        Mark{"MD", 0x590251, 0xBA5686, polygon(6, half / 6)},
        Mark{"SPY", 0x8348FA, 0x865EE6, cross(45)},
        Mark{"SB", 0x545ABA, 0xC684B5, arch()},
        Mark{"MS", 0x7C3908, 0x968A38, bar()},
        Mark{"", 0x1B1E23, 0xE7E9EC, disc()}, // a row without a mark of its own
    };
    const auto found = std::ranges::find(marks, algorithm.abbreviation, &Mark::abbreviation);
    return found == marks.end() ? marks.back() : *found;
}

} // namespace

QColor algorithmColour(const clipping::Algorithm& algorithm, Ground ground)
{
    const Mark& mark = markOf(algorithm);
    return QColor(ground == Ground::Dark ? mark.dark : mark.light);
}

QPainterPath markerPath(const clipping::Algorithm& algorithm) { return markOf(algorithm).path; }

void paintMarker(QPainter& painter, const QRectF& box, const clipping::Algorithm& algorithm,
                 clipping::Form form, Ground ground)
{
    paintMarker(painter, box, markerPath(algorithm), form, algorithmColour(algorithm, ground));
}

void paintMarker(QPainter& painter, const QRectF& box, const QPainterPath& path,
                 clipping::Form form, const QColor& colour)
{
    const double radius = box.width() / 2;
    const bool hollow = form == clipping::Form::Published;
    const double scale = hollow ? 0.86 * radius : radius; // its pen is half outside
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(hollow ? QPen(colour, radius / 4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin)
                          : QPen(Qt::NoPen));
    painter.setBrush(hollow ? QBrush(Qt::NoBrush) : QBrush(colour));
    painter.translate(box.center());
    painter.drawPath(QTransform::fromScale(scale, scale).map(path));
    painter.restore();
}

} // namespace app
