// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/tellers/ends.h"

#include <QCoreApplication>

#include <glm/geometric.hpp>

#include <array>
#include <cmath>

namespace app {

using clipping::Edge;

namespace {

QString tr(const char* text) { return QCoreApplication::translate("skala", text); }

/// The edges e0 to e3 of the table; edge k joins corner k to the next.
constexpr std::array edges{Edge::Bottom, Edge::Right, Edge::Top, Edge::Left};

QString edgeOfTable(const Telling& telling, std::string_view name)
{
    const auto k = telling.value(name);
    return k && *k >= 0 ? edgeWords(edges.at(std::size_t(*k)), telling.specimen.y) : QString();
}

/// "left" or "right" of the line's direction; where y points down, the sides change.
QString sideOfLine(const Telling& telling, bool positive)
{
    return positive == (telling.specimen.y == YAxis::Up) ? tr("left") : tr("right");
}

/// The corner that a line of the pseudo-code asks about: 5 to 8, and 9 to 12 once more.
QString corner(const Telling& telling)
{
    const auto k = std::size_t(telling.step.line - 5) % 4;
    return words::corner(edges[k], edges[(k + 3) % 4], telling.specimen.y);
}

QString cornerSign(const Telling& telling)
{
    const auto f = telling.value("F");
    const double level = f ? *f : telling.value("dx*(y-y1)").value_or(0);
    const double side = f ? 0 : telling.value("dy*(x-x1)").value_or(0);
    const QString relation =
        f ? tr("F = %1").arg(words::number(level)) : words::compared(level, side);
    if (!std::isfinite(level) || !std::isfinite(side))
        return tr("The products are too large for a number (%1): what they say of %2 means "
                  "nothing, but it is believed.")
            .arg(relation, corner(telling));
    if (level == side)
        return telling.holds()
                   ? tr("The line goes right through %1 (%2): counted as %3 of it.")
                         .arg(corner(telling), relation, sideOfLine(telling, true))
                   : tr("Asked strictly: the line goes right through %1 (%2), so that corner does "
                        "not count as %3 of it.")
                         .arg(corner(telling), relation, sideOfLine(telling, true));
    return tr("Seen along the line from End 1 to End 2, %1 lies on the %2 (%3).")
        .arg(corner(telling), sideOfLine(telling, level > side), relation);
}

QString line(const Telling& telling)
{
    return telling.value("pw")
               ? tr("The line through both ends as one vector, their cross product: "
                    "px = %1, py = %2, pw = %3. It tells on which side of the line a point lies.")
                     .arg(words::value(telling, "px"), words::value(telling, "py"),
                          words::value(telling, "pw"))
               : tr("The line is measured from End 1, so that it has no third number that could "
                    "lose its digits: dx = %1, dy = %2.")
                     .arg(words::value(telling, "dx"), words::value(telling, "dy"));
}

QString row(const Telling& telling)
{
    const QString c = words::value(telling, "c");
    if (telling.value("TAB1[c]").value_or(-1) < 0)
        return tr("The pattern of the corners is c = %1: no edge of the window has its corners on "
                  "different sides of the line.")
            .arg(c);
    return tr("The pattern of the corners is c = %1: the side changes along %2 and %3. There, and "
              "only there, the line crosses the window.")
        .arg(c, edgeOfTable(telling, "TAB1[c]"), edgeOfTable(telling, "TAB2[c]"));
}

QString cut(const Telling& telling)
{
    const auto& step = telling.step;
    const bool one = step.line == 16 || step.line == 21;
    const int end = one ? 1 : 2;
    const QString at = words::point(words::endOf(end, telling));
    const Point way = step.segment.b - step.segment.a;
    const Point given = telling.specimen.line.b - telling.specimen.line.a;
    if (step.line == 17 && glm::dot(way, given) < 0)
        return tr("%1 goes to %2, to %3. The published table does not tell where the line comes in "
                  "from where it goes out: the two ends are exchanged now.")
            .arg(words::end(end), telling.edgeText(), at);
    return tr("%1 is outside, so it becomes the point where the line crosses %2: %3.")
        .arg(words::end(end), telling.edgeText(), at);
}

QString test(const Telling& telling)
{
    switch (telling.step.line) {
    case 2:
        return telling.holds() ? tr("Neither end has a bit: both are inside.")
                               : tr("At least one end has a bit, so it is outside.");
    case 3:
        return telling.holds()
                   ? tr("Both ends have a bit in common: they lie beyond one edge.")
                   : tr("The ends have no bit in common: the line may meet the window.");
    case 14:
        return telling.holds() ? tr("The row of the table is empty: the window lies on one side of "
                                    "the line.")
                               : tr("The row of the table names two edges, so the line meets the "
                                    "window.");
    default:
        return cornerSign(telling);
    }
}

QString reject(const Telling& telling)
{
    if (telling.step.line == 3)
        return words::bothBeyond(telling);
    return tr("The line passes the window: nothing of it is visible.") + words::lost(telling);
}

QString sentence(const Telling& telling)
{
    const auto what = telling.step.what;
    const auto& name = telling.step.name;
    if (what == clipping::What::Test)
        return test(telling);
    if (name == "outcodes")
        return words::outcodes(telling);
    if (name == "line")
        return line(telling);
    if (name == "row of the table")
        return row(telling);
    if (what == clipping::What::Cut)
        return cut(telling);
    if (what == clipping::What::Reject)
        return reject(telling);
    return words::acceptedIfInside(telling);
}

} // namespace

extern const Teller skalaTeller;
const Teller skalaTeller{"skala", sentence};

} // namespace app
