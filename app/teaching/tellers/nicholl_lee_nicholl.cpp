// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/tellers/ends.h"

#include <QCoreApplication>

#include <cmath>

// The procedures work in a frame that may be turned or mirrored; the steps, and these sentences,
// are about the line as it was given.

namespace app {

using clipping::Edge;

namespace {

QString tr(const char* text) { return QCoreApplication::translate("nicholl-lee-nicholl", text); }

/// The edge on the other axis than the step's that an end is beyond.
Edge otherEdge(const Telling& telling, int end)
{
    const auto axis = 1 - clipping::axisOf(telling.edge());
    return words::isBeyond(telling, end, clipping::lowerEdge(axis))   ? clipping::lowerEdge(axis)
           : words::isBeyond(telling, end, clipping::upperEdge(axis)) ? clipping::upperEdge(axis)
                                                                      : Edge::None;
}

/// What a comparison with a corner of the window shows; `end` lies beyond the corner.
struct Corner {
    QString name, edge, other;
};
Corner cornerBeyond(const Telling& telling, int end)
{
    const Edge other = otherEdge(telling, end);
    return {words::corner(telling.edge(), other, telling.specimen.y), telling.edgeText(),
            edgeWords(other, telling.specimen.y)};
}

QString whereEndOneIs(const Telling& telling)
{
    const QString beyond = words::whetherBeyond(telling, 1);
    if (!telling.holds())
        return tr("%1.").arg(beyond);
    switch (telling.step.line) {
    case 2:
        return tr("%1: the plane is turned by half, so that right becomes left and one procedure "
                  "does for both. The picture stays as it is.")
            .arg(beyond);
    case 3:
    case 4:
        return tr("%1, neither left nor right of it: the plane is turned by a quarter, so that "
                  "this side becomes the left one. The picture stays as it is.")
            .arg(beyond);
    case 9:
        return tr("%1, beyond a corner: the plane is mirrored, so that this becomes the corner "
                  "that the procedure was written for. The picture stays as it is.")
            .arg(beyond);
    default:
        return tr("%1.").arg(beyond);
    }
}

QString whereEndTwoIs(const Telling& telling)
{
    const QString beyond = words::whetherBeyond(telling, 2);
    if (!telling.holds())
        return tr("%1.").arg(beyond);
    switch (telling.step.line) {
    case 7:
    case 11:
    case 28:
        return tr("%1, and so does End 1.").arg(beyond);
    case 16:
    case 29:
        return tr("%1: it must be asked whether the line passes the window there.").arg(beyond);
    case 30:
        return tr("%1: the plane is mirrored, so that one procedure does for both sides.")
            .arg(beyond);
    case 20:
    case 32:
        return tr("%1: the line leaves the window through %2.").arg(beyond, telling.edgeText());
    case 23:
    case 46:
        return tr("%1: the line could leave through either of two edges.").arg(beyond);
    case 47:
        return tr("%1: the line could leave through either of two edges. The plane is turned by a "
                  "quarter.")
            .arg(beyond);
    case 41:
        return tr("%1: the plane is turned by half, so that right becomes left.").arg(beyond);
    default:
        return tr("%1: the line must leave the window.").arg(beyond);
    }
}

/// A test of slopes, as products: the first value against the second.
QString passesCorner(const Telling& telling)
{
    const int line = telling.step.line;
    const Corner corner = cornerBeyond(telling, line == 14 ? 1 : 2);
    const double first = telling.step.values[0].value, second = telling.step.values[1].value;
    const QString relation = words::compared(first, second);
    const QString through = telling.holds() ? corner.edge : corner.other;
    if (!std::isfinite(first) || !std::isfinite(second))
        return tr("The products are too large for a number (%1): what they say of %2 means "
                  "nothing, but it is believed.")
            .arg(relation, corner.name);
    if (line == 14)
        return tr("Slopes are compared as products, without a division (%1): the line passes %2 on "
                  "the side of %3. Only there can it enter.")
            .arg(relation, corner.name, through);
    if (line == 25 || line == 51)
        return tr("At %1 the products say (%2): the line leaves through %3.")
            .arg(corner.name, relation, through);
    if (telling.holds())
        return tr("The line passes outside %1 (%2): it misses the window.")
            .arg(corner.name, relation);
    return tr("The line passes inside %1 (%2): it meets the window, and enters through %3.")
        .arg(corner.name, relation, corner.edge);
}

QString product(const Telling& telling)
{
    const Telling& t = telling;
    switch (t.step.line) {
    case 13:
    case 50:
        return tr("Two products hold what a corner says of the line's slope: pymax = %1, "
                  "pxmin = %2. No division is needed to compare slopes.")
            .arg(words::value(t, "pymax"), words::value(t, "pxmin"));
    case 36:
        return tr("Two products hold what a corner says of the line's slope: pxmin = %1, "
                  "pymin = %2. No division is needed to compare slopes.")
            .arg(words::value(t, "pxmin"), words::value(t, "pymin"));
    case 17:
        return tr("One more product, for the next corner: pymin = %1.")
            .arg(words::value(t, "pymin"));
    default:
        return tr("One more product, for the next corner: pxmax = %1.")
            .arg(words::value(t, "pxmax"));
    }
}

QString cut(const Telling& telling)
{
    const int end = telling.step.name == "cut a" ? 1 : 2;
    return tr("%1 moves along the line to %2, to %3. It is certain by now that this end is "
              "visible.")
        .arg(words::end(end), telling.edgeText(), words::point(words::endOf(end, telling)));
}

QString extent(const Telling& telling)
{
    const Point d = telling.specimen.line.b - telling.specimen.line.a;
    const bool changed = telling.value("dx") != d.x || telling.value("dy") != d.y;
    return (changed
                ? tr("How far it is from End 1 to End 2 in the plane as it is turned or scaled: "
                     "dx = %1, dy = %2.")
                : tr("How far it is from End 1 to End 2: dx = %1, dy = %2."))
        .arg(words::value(telling, "dx"), words::value(telling, "dy"));
}

QString other(const Telling& telling)
{
    const auto& name = telling.step.name;
    if (name == "dx, dy")
        return extent(telling);
    if (name == "inside")
        return tr("End 1 is inside the window: something is visible for certain, and only End 2 is "
                  "in question.");
    if (name == "beside")
        return tr("End 1 is beside the window, neither above nor below it.");
    if (name == "mirror")
        return tr("The plane is mirrored in a diagonal, so that %1 becomes the left one and the "
                  "same procedure does for it. The picture stays as it is.")
            .arg(telling.edgeText());
    if (name.starts_with("product"))
        return product(telling);
    return {};
}

QString sentence(const Telling& telling)
{
    const auto& step = telling.step;
    if (step.what == clipping::What::Test) {
        if (!step.values.empty())
            return passesCorner(telling);
        return step.line <= 4 || step.line == 8 || step.line == 9 ? whereEndOneIs(telling)
                                                                  : whereEndTwoIs(telling);
    }
    if (step.what == clipping::What::Reject)
        return step.line == 18 || step.line == 37
                   ? tr("The line misses the window: nothing of it is visible, and nothing had to "
                        "be divided to know that.")
                         + words::lost(telling)
                   : words::bothBeyond(telling);
    if (step.what == clipping::What::Cut)
        return cut(telling);
    if (step.what == clipping::What::Accept)
        return words::acceptedIfInside(telling);
    return other(telling);
}

} // namespace

extern const Teller nichollLeeNichollTeller;
const Teller nichollLeeNichollTeller{"nicholl-lee-nicholl", sentence};

} // namespace app
