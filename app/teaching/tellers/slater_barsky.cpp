// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/overlays/family.h"
#include "app/teaching/teaching.h"
#include "app/teaching/tellers/ends.h"

#include <QCoreApplication>

#include <array>
#include <cmath>

namespace app {

using clipping::Edge;

namespace {

QString tr(const char* text) { return QCoreApplication::translate("slater-barsky", text); }

/// The walk goes to the right, from End a to End b.
int first(const Telling& telling) { return int(telling.known("a").value_or(1)); }
int last(const Telling& telling) { return int(telling.known("b").value_or(2)); }

int cellOf(const Telling& telling) { return int(telling.known("c").value_or(4)); }
bool isUp(const Telling& telling) { return telling.known("dy").value_or(0) > 0; }

QString order(const Telling& telling)
{
    const auto& [a, b] = telling.specimen.line;
    return (telling.holds() ? tr("End 2 lies further left than End 1 (%1). The walk goes to the "
                                 "right, so it begins at End 2: a is 2, and b is 1.")
                            : tr("End 1 does not lie right of End 2 (%1): the walk begins at End "
                                 "1, so a is 1, and b is 2."))
        .arg(words::compared(a.x, b.x));
}

/// Whether both ends are to the right of the window, or both to its left.
QString besideTheWindow(const Telling& telling)
{
    if (telling.holds())
        return tr("Both ends lie %1.").arg(words::beyond(telling.edge(), telling.specimen.y));
    const auto relation = [&](int end, Edge edge) {
        return words::compared(words::endOf(end, telling), edge, telling.specimen.window);
    };
    return tr("%1 does not lie right of the window (%2), and %3 does not lie left of it (%4).")
        .arg(words::end(first(telling)), relation(first(telling), Edge::Right),
             words::end(last(telling)), relation(last(telling), Edge::Left));
}

/// The current cell as a place: "the middle cell, which is the window", "the cell left of the
/// window".
QString place(const Telling& telling)
{
    const int cell = cellOf(telling);
    const int row = telling.specimen.y == YAxis::Up ? cell / 3 : 2 - cell / 3;
    const bool left = cell % 3 == 0;
    if (cell == 4)
        return tr("the middle cell, which is the window");
    return row == 1   ? tr("the cell left of the window")
           : row == 0 ? left ? tr("the cell below and left of the window")
                             : tr("the cell below the window")
           : left ? tr("the cell above and left of the window")
                      : tr("the cell above the window");
}

QString errorTerm(const Telling& telling)
{
    if (std::isnan(telling.known("e").value_or(0)))
        return tr("The products are too large for a number: the error term e is not a number "
                  "(NaN).");
    return tr("The error term e = %1 tells on which side of the corner ahead the line passes, "
              "without a division.")
        .arg(words::value(telling, "e"));
}

QString rising(const Telling& telling)
{
    const double dy = telling.known("dy").value_or(0);
    const QString relation = words::compared(dy, 0);
    if (dy > 0 || dy < 0)
        return ((dy > 0) == (telling.specimen.y == YAxis::Up)
                    ? tr("The walk goes upwards (dy: %1).")
                    : tr("The walk goes downwards (dy: %1)."))
            .arg(relation);
    return tr("The walk goes neither up nor down (dy: %1).").arg(relation);
}

/// The edge whose infinite line contains the side at which the walk leaves its cell.
Edge crossed(const Telling& telling)
{
    if (telling.holds())
        return telling.edge();
    const int row = cellOf(telling) / 3;
    return isUp(telling) ? (row == 0 ? Edge::Bottom : Edge::Top)
                         : (row == 2 ? Edge::Top : Edge::Bottom);
}

/// The side at which the walk leaves its cell: the right one if the test holds.
QString leaving(const Telling& telling)
{
    const double e = telling.known("e").value_or(0);
    const QString relation = words::compared(e, 0);
    const QString edge = edgeWords(crossed(telling), telling.specimen.y);
    if (std::isnan(e))
        return tr("The products are too large for a number: e is not a number (NaN), and the walk "
                  "goes on over the line of %1 all the same.")
            .arg(edge);
    if (e == 0)
        return tr("The line goes right through the corner ahead (e = 0): the walk goes on over the "
                  "line of %1.")
            .arg(edge);
    if (!telling.holds())
        return tr("By the sign of e (%1) the line passes left of the corner ahead: the walk goes "
                  "on over the line of %2.")
            .arg(relation, edge);
    return (isUp(telling) == (telling.specimen.y == YAxis::Up)
                ? tr("By the sign of e (%1) the line passes below the corner ahead: the walk goes "
                     "on to the right, over the line of %2.")
                : tr("By the sign of e (%1) the line passes above the corner ahead: the walk goes "
                     "on to the right, over the line of %2."))
        .arg(relation, edge);
}

/// The meaning of a test of the current cell.
enum class Fate : std::uint8_t { Misses, Enters, Leaves };

QString inCell(const Telling& telling, const char* cells, Fate fate)
{
    if (!telling.holds())
        return (fate == Fate::Misses
                    ? tr("The walk is not in cell %1, from where it would miss the window.")
                : fate == Fate::Enters
                    ? tr("Nor is it in cell %1, from where it would come into the window.")
                    : tr("Nor is it in cell %1, from where it would leave the window."))
            .arg(tr(cells));
    return (fate == Fate::Misses
                ? tr("The walk is in cell %1, %2: going on from there, it misses the window.")
            : fate == Fate::Enters
                ? tr("The walk is in cell %1, %2: from there it comes into the window.")
                : tr("The walk is in cell %1, %2: from there it leaves the window."))
        .arg(cellOf(telling))
        .arg(place(telling));
}

QString insideTest(const Telling& telling)
{
    if (telling.step.line == 17)
        return telling.holds()
                   ? tr("The walk begins in the middle cell, and the other end is there, too.")
                   : tr("Not both ends are inside the window: the walk finds the part that is.");
    return telling.holds() ? tr("%1 is inside: the walk is over.").arg(words::end(last(telling)))
                           : tr("%1 is not inside: the walk goes on, out of the window again.")
                                 .arg(words::end(last(telling)));
}

/// The tests of the published form only, from line 22 on.
QString publishedTest(const Telling& telling)
{
    switch (telling.step.line) {
    case 22:
        return rising(telling);
    case 23:
    case 42:
        return leaving(telling);
    case 24:
        return inCell(telling, "1", Fate::Misses);
    case 33:
    case 52:
        return inCell(telling, "3", Fate::Misses);
    case 43:
        return inCell(telling, "7", Fate::Misses);
    case 25:
    case 44:
        return inCell(telling, "3", Fate::Enters);
    case 34:
        return inCell(telling, "1", Fate::Enters);
    case 53:
        return inCell(telling, "7", Fate::Enters);
    case 28:
    case 37:
    case 47:
    case 56:
        return inCell(telling, "4", Fate::Leaves);
    default:
        return insideTest(telling);
    }
}

/// The tests of the corrected form, from line 19 on.
QString correctedTest(const Telling& telling)
{
    switch (telling.step.line) {
    case 19:
        return telling.holds()
                   ? tr("The line runs along an axis: no division is needed to clip it.")
                   : tr("The line runs along no axis.");
    case 27:
        return leaving(telling);
    case 28:
        return inCell(telling, "1 or 7", Fate::Misses);
    case 37:
        return inCell(telling, "3", Fate::Misses);
    case 29:
        return inCell(telling, "3", Fate::Enters);
    case 38:
        return inCell(telling, "1 or 7", Fate::Enters);
    case 32:
    case 41:
        return inCell(telling, "4", Fate::Leaves);
    default:
        return insideTest(telling);
    }
}

QString test(const Telling& telling)
{
    const int line = telling.step.line;
    if (line == 3)
        return order(telling);
    if (line == 5)
        return besideTheWindow(telling);
    if (line < 17)
        return tr("%1.").arg(words::whetherBeyond(
            telling, line == 11 || line == 14 ? last(telling) : first(telling)));
    if (line == 17)
        return insideTest(telling);
    return words::isPublished(telling) ? publishedTest(telling) : correctedTest(telling);
}

QString cut(const Telling& telling)
{
    const bool leaves = cellOf(telling) == 4;
    const int end = leaves ? last(telling) : first(telling);
    return (leaves ? tr("Here the walk leaves the window: %1 moves to %2, to %3.")
                   : tr("Here the walk comes into the window: %1 moves to %2, to %3."))
        .arg(words::end(end), telling.edgeText(), words::point(words::endOf(end, telling)));
}

QString rejected(const Telling& telling)
{
    if (telling.step.line < 17)
        return words::bothBeyond(telling);
    return tr("From here the walk can only go away from the window: nothing of the line is "
              "visible.")
           + words::lost(telling);
}

QString nextCorner(const Telling& telling)
{
    return tr("The next corner ahead gives e = %1.").arg(words::value(telling, "e"));
}

QString nextCell(const Telling& telling)
{
    const QString cell =
        tr("The walk is in cell %1 now, %2.").arg(cellOf(telling)).arg(place(telling));
    return telling.value("e") ? cell + u' ' + nextCorner(telling) : cell;
}

/// The new value of a variable.
QString given(const Telling& telling)
{
    const auto& name = telling.step.name;
    const Edge in = isUp(telling) ? Edge::Bottom : Edge::Top;
    const Edge out = isUp(telling) ? Edge::Top : Edge::Bottom;
    if (name == "c")
        return telling.step.line == 16 ? tr("%1 is in cell %2, %3: the walk begins there.")
                                             .arg(words::end(first(telling)),
                                                  words::value(telling, "c"), place(telling))
                                       : nextCell(telling);
    if (name == "dy")
        return tr("How far it is from %1 to %2: dx = %3, dy = %4.")
            .arg(words::end(first(telling)), words::end(last(telling)), words::value(telling, "dx"),
                 words::value(telling, "dy"));
    if (name == "left")
        return tr("Both ends are held inside the window: what is left goes from %1 to %2.")
            .arg(words::point(telling.step.segment.a), words::point(telling.step.segment.b));
    if (name == "up")
        return rising(telling);
    if (name == "yOut")
        return tr("On such a way the line can come into the window over %1 or the left one, and "
                  "leave it over %2 or the right one.")
            .arg(edgeWords(in, telling.specimen.y), edgeWords(out, telling.specimen.y));
    if (name == "Y")
        return tr("The corner ahead is at %1.")
            .arg(words::point({telling.known("X").value_or(0), telling.known("Y").value_or(0)}));
    return telling.step.line == 44 ? nextCorner(telling) : errorTerm(telling);
}

QString sentence(const Telling& telling)
{
    switch (telling.step.what) {
    case clipping::What::Test:
        return test(telling);
    case clipping::What::Cut:
        return cut(telling);
    case clipping::What::Reject:
        return rejected(telling);
    case clipping::What::Accept:
        return words::acceptedIfInside(telling);
    default:
        return given(telling);
    }
}

constexpr auto variables = std::to_array<VariableUnit>({
    {"e", ValueUnit::Area},
    {"X", ValueUnit::X},
    {"Y", ValueUnit::Y},
    {"yIn", ValueUnit::Y},
    {"yOut", ValueUnit::Y},
});

} // namespace

extern const Teaching slaterBarskyTeaching;
const Teaching slaterBarskyTeaching{
    .key = "slater-barsky",
    .sentence = sentence,
    .overlay = cellOverlay,
    .figure = {.line = {{-150, 20}, {140, -40}}},
    .variables = variables,
};

} // namespace app
