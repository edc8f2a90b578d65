// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/tellers/ends.h"

#include "app/overlays/half_plane.h"
#include "clipping/outcode.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace app::words {

using clipping::Edge;

namespace {

QString tr(const char* text) { return QCoreApplication::translate("tellers", text); }

/// The distance of a point outside a window; 0 if it is not outside.
double outside(const Point& p, const clipping::Window& window)
{
    return std::max(
        {window.min.x - p.x, p.x - window.max.x, window.min.y - p.y, p.y - window.max.y, 0.0});
}

/// An edge that both ends of the original line lie beyond.
Edge commonEdge(const Specimen& specimen)
{
    const unsigned common = clipping::outcodeOf(specimen.line.a, specimen.window)
                            & clipping::outcodeOf(specimen.line.b, specimen.window);
    return common & clipping::outcode::left     ? Edge::Left
           : common & clipping::outcode::right  ? Edge::Right
           : common & clipping::outcode::bottom ? Edge::Bottom
                                                : Edge::Top;
}

/// The exact visible part.
std::optional<clipping::Segment> exactPiece(const Specimen& specimen)
{
    return clipping::exactAlgorithm().corrected.clip(specimen.line, specimen.window);
}

} // namespace

Point endOf(int number, const Telling& telling)
{
    return number == 1 ? telling.step.segment.a : telling.step.segment.b;
}

bool isBeyond(const Telling& telling, int number, Edge edge)
{
    return edge != Edge::None
           && app::isBeyond(endOf(number, telling), edge, telling.specimen.window);
}

QString whetherBeyond(const Telling& telling, int number)
{
    const QString side = beyond(telling.edge(), telling.specimen.y);
    const QString relation =
        compared(endOf(number, telling), telling.edge(), telling.specimen.window);
    return isBeyond(telling, number, telling.edge())
               ? tr("%1 lies %2 (%3)").arg(end(number), side, relation)
               : tr("%1 does not lie %2 (%3)").arg(end(number), side, relation);
}

bool asksTheWay(const Telling& telling)
{
    return telling.known("moved") == 1 && clipping::axisOf(telling.edge()) == 1;
}

QString whetherPassed(const Telling& telling, int number)
{
    const double rise = telling.known("rise").value_or(0);
    const double gap = clipping::levelOf(telling.edge(), telling.specimen.window)
                       - telling.known("yi").value_or(0);
    return (telling.holds()
                ? tr("On its way %1 has passed %2: it has moved by %3 in y, and %2 was %4 away "
                     "(%5). It lies %6.")
                : tr("On its way %1 has not passed %2: it has moved by %3 in y, and %2 was %4 "
                     "away (%5). It does not lie %6."))
        .arg(end(number), telling.edgeText(), words::number(rise), words::number(gap),
             compared(rise, gap), beyond(telling.edge(), telling.specimen.y));
}

QString bothBeyond(const Telling& telling)
{
    const auto& [a, b] = telling.specimen.line;
    const Edge edge = telling.edge() != Edge::None ? telling.edge() : commonEdge(telling.specimen);
    const auto& window = telling.specimen.window;
    return tr("Both ends lie %1 (%2 and %3): no point of the line can be inside.")
        .arg(beyond(edge, telling.specimen.y), compared(a, edge, window),
             compared(b, edge, window));
}

QString corner(Edge one, Edge other, YAxis y)
{
    static constexpr std::array<const char*, 4> corners{
        "the bottom left corner", "the bottom right corner", "the top left corner",
        "the top right corner"};
    if (one > other)
        std::swap(one, other);
    if (one == Edge::None || one > Edge::Right || other < Edge::Bottom)
        return {};
    const bool top = (other == Edge::Top) == (y == YAxis::Up);
    return tr(corners[(top ? 2 : 0) + (one == Edge::Right ? 1 : 0)]);
}

QString outcodes(const Telling& telling)
{
    const auto code = [&](const char* name) {
        return outcodeText(unsigned(telling.value(name).value_or(0)));
    };
    return tr("The outcode of End 1 is %1, that of End 2 is %2. Their bits mean %3.")
        .arg(code("code1"), code("code2"), outcodeBits());
}

QString productsTooLarge(const QString& products, const QString& corner)
{
    return tr("The products are too large for a number (%1): what they say of %2 means nothing, "
              "but it is believed.")
        .arg(products, corner);
}

QString value(const Telling& telling, std::string_view name)
{
    const auto value = telling.value(name);
    return value ? number(*value) : QString();
}

QString held(const Telling& telling)
{
    return telling.before && telling.before->segment != telling.step.segment
               ? tr("Rounding had put an end just outside: it is moved back to the window.")
               : tr("Rounding has put no end outside the window, so both stay where they are.");
}

QString acceptedIfInside(const Telling& telling)
{
    for (const int end : {1, 2})
        if (const Point p = endOf(end, telling); std::isnan(p.x) || std::isnan(p.y))
            return tr("What is left is taken for visible, but %1 is no point any more: %2.")
                .arg(words::end(end), point(p));
    for (const int end : {1, 2})
        if (const double far = outside(endOf(end, telling), telling.specimen.window); far > 0)
            return (std::isfinite(far)
                        ? tr("What is left is taken for visible, but rounding has left %1 outside "
                             "the window, by %2.")
                        : tr(
                            "What is left is taken for visible, but numbers too large have left %1 "
                            "outside the window, by %2."))
                .arg(words::end(end), words::number(far));
    if (!exactPiece(telling.specimen))
        return accepted(telling) + QStringLiteral(" ")
               + tr("That is wrong: the line misses the window, by less than rounding can tell.");
    return accepted(telling);
}

QString lost(const Telling& telling)
{
    if (!isPublished(telling))
        return {};
    const auto piece = exactPiece(telling.specimen);
    if (!piece)
        return {};
    return QStringLiteral(" ")
           + (piece->a == piece->b
                  ? tr("That is wrong: the line touches the window at %1.").arg(point(piece->a))
                  : tr("That is wrong: from %1 to %2 the line is inside.")
                        .arg(point(piece->a), point(piece->b)));
}

} // namespace app::words
