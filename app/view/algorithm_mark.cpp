// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/algorithm_mark.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace app {

namespace {

/// A star around (0, 0) that fits into the circle of radius 1.
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

QPainterPath crossShape(double turn)
{
    QPainterPath one, other;
    one.addRect(-0.32, -0.95, 0.64, 1.9);
    other.addRect(-0.95, -0.32, 1.9, 0.64);
    return QTransform().rotate(turn).map(one.united(other)).simplified();
}

/// An arch with a round top.
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

struct OwnMark {
    std::string_view abbreviation;
    QRgb light, dark;
    QPainterPath path;
};

std::span<const OwnMark> ownMarks()
{
    constexpr double half = std::numbers::pi;
    static const std::array marks{
        OwnMark{"EX", 0x202117, 0xFCF9FC, star(5, 0.42, 0)},
        OwnMark{"EX one by one", 0x6B6E66, 0xA9ABA4, star(4, 0.42, 0)}, // only in the experiments
        OwnMark{"CS", 0x091C86, 0x8194FF, disc()},
        OwnMark{"LB", 0x1793D8, 0x65D7FE, polygon(4, half / 4)},
        OwnMark{"CB", 0x005756, 0x0EC676, polygon(4, 0)},
        OwnMark{"NLN", 0x4C965C, 0xB6FD88, polygon(3, 0)},
        OwnMark{"Skala", 0xB07A00, 0xCAD30E, polygon(3, half)},
        OwnMark{"KWC", 0x965C87, 0xFFA3BB, crossShape(0)},
        OwnMark{"MD", 0x590251, 0xBA5686, polygon(6, half / 6)},
        OwnMark{"SPY", 0x8348FA, 0x865EE6, crossShape(45)},
        OwnMark{"SB", 0x545ABA, 0xC684B5, arch()},
        OwnMark{"WN", 0x676F48, 0x93AC00, polygon(5, 0)},
        OwnMark{"MS", 0x7C3908, 0x968A38, bar()},
    };
    return marks;
}

const OwnMark* ownMarkOf(const clipping::Algorithm& algorithm)
{
    const auto all = ownMarks();
    const auto found = std::ranges::find(all, algorithm.abbreviation, &OwnMark::abbreviation);
    return found == all.end() ? nullptr : &*found;
}

/// The mark for row `number` (from 0) among the rows without a mark of their own. The first colours
/// are crimson and olive, which no own mark uses; no own mark is a star with so many points.
AlgorithmMark spareMark(int number)
{
    const int hue = (350 + 85 * number) % 360;
    return {QColor::fromHsv(hue, 220, 130), QColor::fromHsv(hue, 110, 245),
            star(6 + number, 0.6, 0)};
}

} // namespace

AlgorithmMark markOf(const clipping::Algorithm& algorithm,
                     std::span<const clipping::Algorithm> catalogue)
{
    if (const OwnMark* own = ownMarkOf(algorithm))
        return {QColor(own->light), QColor(own->dark), own->path};
    int number = 0;
    for (const clipping::Algorithm& row : catalogue)
        if (row.key == algorithm.key)
            return spareMark(number);
        else
            number += ownMarkOf(row) == nullptr;
    return {QColor(0x1B1E23), QColor(0xE7E9EC), disc()};
}

QColor algorithmColour(const clipping::Algorithm& algorithm, Ground ground)
{
    const AlgorithmMark mark = markOf(algorithm);
    return ground == Ground::Dark ? mark.dark : mark.light;
}

QPainterPath markerPath(const clipping::Algorithm& algorithm) { return markOf(algorithm).path; }

void paintMarker(QPainter& painter, const QRectF& box, const Variant& variant, Ground ground)
{
    paintMarker(painter, box, markerPath(*variant.algorithm), variant.form,
                algorithmColour(*variant.algorithm, ground));
}

void paintMarker(QPainter& painter, const QRectF& box, const QPainterPath& path,
                 clipping::Form form, const QColor& colour)
{
    const double radius = box.width() / 2;
    const bool hollow = form == clipping::Form::Published;
    const double scale = hollow ? 0.86 * radius : radius; // half the pen is outside
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
