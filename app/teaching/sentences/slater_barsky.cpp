// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/overlays/parts.h"
#include "app/teaching/sentences/ends.h"
#include "app/teaching/teaching.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace app {

using clipping::Edge;

namespace {

/// The walk goes to the right, from End a to End b.
int first(const SentenceContext& context) { return int(context.known("a").value_or(1)); }
int last(const SentenceContext& context) { return int(context.known("b").value_or(2)); }

int cellOf(const SentenceContext& context) { return int(context.known("c").value_or(4)); }
bool isUp(const SentenceContext& context) { return context.known("dy").value_or(0) > 0; }

QString order(const SentenceContext& context)
{
    const auto& [a, b] = context.tracedLine.line;
    return (context.holds()
                ? Text::tr("End 2 lies further left than End 1 (%1). The walk goes to the "
                           "right, so it begins at End 2: a = 2 and b = 1.")
                : Text::tr("End 1 does not lie right of End 2 (%1), so the walk begins at "
                           "End 1: a = 1 and b = 2."))
        .arg(words::compared(a.x, b.x));
}

/// Whether both ends are to the right of the window, or both to its left.
QString besideTheWindow(const SentenceContext& context)
{
    if (context.holds())
        return Text::tr("Both ends lie %1.")
            .arg(words::beyond(context.edge(), context.tracedLine.y));
    const auto relation = [&](int end, Edge edge) {
        return words::compared(words::endOf(end, context), edge, context.tracedLine.window);
    };
    return Text::tr(
               "%1 does not lie right of the window (%2), and %3 does not lie left of it (%4).")
        .arg(words::end(first(context)), relation(first(context), Edge::Right),
             words::end(last(context)), relation(last(context), Edge::Left));
}

/// The current cell as a place: "the middle cell, which is the window", "the cell left of the
/// window".
QString slaterBarskyPlace(const SentenceContext& context)
{
    const int cell = cellOf(context);
    const int row = context.tracedLine.y == YAxis::Up ? cell / 3 : 2 - cell / 3;
    const bool left = cell % 3 == 0;
    if (cell == 4)
        return Text::tr("the middle cell, which is the window");
    return row == 1   ? Text::tr("the cell left of the window")
           : row == 0 ? left ? Text::tr("the cell below and left of the window")
                             : Text::tr("the cell below the window")
           : left ? Text::tr("the cell above and left of the window")
                      : Text::tr("the cell above the window");
}

QString errorTerm(const SentenceContext& context)
{
    if (std::isnan(context.known("e").value_or(0)))
        return Text::tr("The products overflow: the error term e is not a number (NaN).");
    return Text::tr(
               "The error term e = %1 tells, without a division, on which side of the corner ahead "
               "the line passes.")
        .arg(words::value(context, "e"));
}

QString rising(const SentenceContext& context)
{
    const double dy = context.known("dy").value_or(0);
    const QString relation = words::compared(dy, 0);
    if (dy > 0 || dy < 0)
        return ((dy > 0) == (context.tracedLine.y == YAxis::Up)
                    ? Text::tr("The walk goes upwards (dy: %1).")
                    : Text::tr("The walk goes downwards (dy: %1)."))
            .arg(relation);
    return Text::tr("The walk goes neither up nor down (dy: %1).").arg(relation);
}

/// The edge whose infinite line contains the side at which the walk leaves its cell.
Edge crossed(const SentenceContext& context)
{
    if (context.holds())
        return context.edge();
    const int row = cellOf(context) / 3;
    return isUp(context) ? (row == 0 ? Edge::Bottom : Edge::Top)
                         : (row == 2 ? Edge::Top : Edge::Bottom);
}

/// The side at which the walk leaves its cell: the right one if the test holds.
QString leaving(const SentenceContext& context)
{
    const double e = context.known("e").value_or(0);
    const QString relation = words::compared(e, 0);
    const QString edge = edgeWords(crossed(context), context.tracedLine.y);
    if (std::isnan(e))
        return Text::tr(
                   "The products overflow: e is not a number (NaN). The walk nevertheless crosses "
                   "the line of %1.")
            .arg(edge);
    if (e == 0)
        return Text::tr(
                   "The line passes exactly through the corner ahead (e = 0): the walk crosses the "
                   "line of %1.")
            .arg(edge);
    if (!context.holds())
        return Text::tr("By the sign of e (%1), the line passes left of the corner ahead: the walk "
                        "crosses the line of %2.")
            .arg(relation, edge);
    return (isUp(context) == (context.tracedLine.y == YAxis::Up)
                ? Text::tr(
                    "By the sign of e (%1), the line passes below the corner ahead: the walk goes "
                    "right, across the line of %2.")
                : Text::tr(
                    "By the sign of e (%1), the line passes above the corner ahead: the walk goes "
                    "right, across the line of %2."))
        .arg(relation, edge);
}

/// The meaning of a test of the current cell.
enum class Fate : std::uint8_t { Misses, Enters, Leaves };

QString inCell(const SentenceContext& context, const char* cells, Fate fate)
{
    if (!context.holds())
        return (fate == Fate::Misses
                    ? Text::tr("The walk is not in cell %1, from where it would miss the window.")
                : fate == Fate::Enters
                    ? Text::tr("The walk is not in cell %1, from where it would enter the window.")
                    : Text::tr("The walk is not in cell %1, from where it would leave the window."))
            .arg(Text::tr(cells));
    return (fate == Fate::Misses
                ? Text::tr("The walk is in cell %1, %2: going on from there, it misses the window.")
            : fate == Fate::Enters
                ? Text::tr("The walk is in cell %1, %2: from there it enters the window.")
                : Text::tr("The walk is in cell %1, %2: from there it leaves the window."))
        .arg(cellOf(context))
        .arg(slaterBarskyPlace(context));
}

QString insideTest(const SentenceContext& context)
{
    if (context.at("inside"))
        return context.holds()
                   ? Text::tr("The walk begins in the middle cell, and the other end is there too.")
                   : Text::tr(
                       "At least one end is outside the window: the walk finds the visible part.");
    return context.holds()
               ? Text::tr("%1 is inside: the walk is over.").arg(words::end(last(context)))
               : Text::tr("%1 is not inside: the walk goes on, out of the window again.")
                     .arg(words::end(last(context)));
}

/// A test of the cell in which the walk is.
struct CellTest {
    std::string_view label;
    const char* cells;
    Fate fate;
};
constexpr std::array cellTests{
    CellTest{"upMissesRight", "1", Fate::Misses},
    CellTest{"upMissesTop", "3", Fate::Misses},
    CellTest{"downMissesBottom", "3", Fate::Misses},
    CellTest{"missesAcross", "3", Fate::Misses},
    CellTest{"downMissesRight", "7", Fate::Misses},
    CellTest{"missesRight", QT_TRANSLATE_NOOP("Text", "1 or 7"), Fate::Misses},
    CellTest{"upFromLeft", "3", Fate::Enters},
    CellTest{"downFromLeft", "3", Fate::Enters},
    CellTest{"fromLeft", "3", Fate::Enters},
    CellTest{"upFromBottom", "1", Fate::Enters},
    CellTest{"downFromTop", "7", Fate::Enters},
    CellTest{"fromAcross", QT_TRANSLATE_NOOP("Text", "1 or 7"), Fate::Enters},
    CellTest{"upToRight", "4", Fate::Leaves},
    CellTest{"upToTop", "4", Fate::Leaves},
    CellTest{"downToRight", "4", Fate::Leaves},
    CellTest{"downToBottom", "4", Fate::Leaves},
    CellTest{"toRight", "4", Fate::Leaves},
    CellTest{"toAcross", "4", Fate::Leaves},
};

/// The tests of the walk from cell to cell.
QString walkTest(const SentenceContext& context)
{
    if (context.at("up"))
        return rising(context);
    if (context.at("straight"))
        return context.holds() ? Text::tr(
                   "The line is horizontal or vertical: no division is needed to clip it.")
                               : Text::tr("The line is neither horizontal nor vertical.");
    if (context.at("upRight", "downRight", "right"))
        return leaving(context);
    const auto* const test = std::ranges::find(cellTests, context.step.label, &CellTest::label);
    return test == cellTests.end() ? insideTest(context) : inCell(context, test->cells, test->fate);
}

QString slaterBarskyTest(const SentenceContext& context)
{
    if (context.at("swap"))
        return order(context);
    if (context.at("besideX"))
        return besideTheWindow(context);
    if (context.at("left", "below", "above"))
        return Text::tr("%1.").arg(words::whetherBeyond(context, first(context)));
    if (context.at("bothBelow", "bothAbove"))
        return Text::tr("%1.").arg(words::whetherBeyond(context, last(context)));
    return walkTest(context);
}

QString slaterBarskyCut(const SentenceContext& context)
{
    const bool leaves = cellOf(context) == 4;
    const int end = leaves ? last(context) : first(context);
    return (leaves ? Text::tr("Here the walk leaves the window: %1 moves to %2, to %3.")
                   : Text::tr("Here the walk enters the window: %1 moves to %2, to %3."))
        .arg(words::end(end), context.edgeText(), words::point(words::endOf(end, context)));
}

QString slaterBarskyRejected(const SentenceContext& context)
{
    if (context.at("besideX", "bothBelow", "bothAbove"))
        return words::bothBeyond(context);
    return Text::tr("From here the walk can only go away from the window: nothing of the line is "
                    "visible.")
           + words::lost(context);
}

QString nextCorner(const SentenceContext& context)
{
    return Text::tr("The next corner ahead gives e = %1.").arg(words::value(context, "e"));
}

QString nextCell(const SentenceContext& context)
{
    const QString cell = Text::tr("The walk is in cell %1 now, %2.")
                             .arg(cellOf(context))
                             .arg(slaterBarskyPlace(context));
    return context.value("e") ? cell + u' ' + nextCorner(context) : cell;
}

/// The new value of a variable.
QString slaterBarskyGiven(const SentenceContext& context)
{
    const auto& name = context.step.name;
    const Edge in = isUp(context) ? Edge::Bottom : Edge::Top;
    const Edge out = isUp(context) ? Edge::Top : Edge::Bottom;
    if (name == "c")
        return context.at("cell") ? Text::tr("%1 is in cell %2, %3: the walk begins there.")
                                        .arg(words::end(first(context)), words::value(context, "c"),
                                             slaterBarskyPlace(context))
                                  : nextCell(context);
    if (name == "dy")
        return Text::tr("From %1 to %2: dx = %3, dy = %4.")
            .arg(words::end(first(context)), words::end(last(context)), words::value(context, "dx"),
                 words::value(context, "dy"));
    if (name == "left")
        return Text::tr(
                   "Both ends are held inside the window: the remaining part runs from %1 to %2.")
            .arg(words::point(context.step.segment.a), words::point(context.step.segment.b));
    if (name == "up")
        return rising(context);
    if (name == "yOut")
        return Text::tr(
                   "Such a line can enter the window at %1 or the left edge, and leave it at %2 or "
                   "the right edge.")
            .arg(edgeWords(in, context.tracedLine.y), edgeWords(out, context.tracedLine.y));
    if (name == "Y")
        return Text::tr("The corner ahead is at %1.")
            .arg(words::point({context.known("X").value_or(0), context.known("Y").value_or(0)}));
    return context.at("nextError") ? nextCorner(context) : errorTerm(context);
}

QString slaterBarskySentence(const SentenceContext& context)
{
    switch (context.step.what) {
    case clipping::What::Test:
        return slaterBarskyTest(context);
    case clipping::What::Cut:
        return slaterBarskyCut(context);
    case clipping::What::Reject:
        return slaterBarskyRejected(context);
    case clipping::What::Accept:
        return words::acceptedIfInside(context);
    default:
        return slaterBarskyGiven(context);
    }
}

constexpr auto slaterBarskyVariables = std::to_array<VariableUnit>({
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
    .sentence = slaterBarskySentence,
    .overlay = cellOverlay,
    .figure = {.line = {{-150, 20}, {140, -40}}},
    .variables = slaterBarskyVariables,
};

} // namespace app
