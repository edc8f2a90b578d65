// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/overlays/parts.h"
#include "app/teaching/sentences/ends.h"
#include "app/teaching/teaching.h"

#include <algorithm>
#include <array>
#include <cmath>

// The procedures work in a frame that may be rotated or mirrored; the steps and these sentences
// refer to the original line.

namespace app {

using clipping::Edge;

namespace {

/// The edge of the other axis that an end is beyond.
Edge otherEdge(const SentenceContext& context, int end)
{
    const auto axis = 1 - clipping::axisOf(context.edge());
    return words::isBeyond(context, end, clipping::lowerEdge(axis))   ? clipping::lowerEdge(axis)
           : words::isBeyond(context, end, clipping::upperEdge(axis)) ? clipping::upperEdge(axis)
                                                                      : Edge::NoEdge;
}

/// The result of a comparison with a corner of the window; `end` lies beyond the corner.
struct Corner {
    QString name, edge, other;
};
Corner cornerBeyond(const SentenceContext& context, int end)
{
    const Edge other = otherEdge(context, end);
    return {words::corner(context.edge(), other, context.tracedLine.y), context.edgeText(),
            edgeWords(other, context.tracedLine.y)};
}

/// The procedures are written for one region of End 1; this is what happens in the other regions.
QString whereEndOneIs(const SentenceContext& context)
{
    const QString beyond = words::whetherBeyond(context, 1);
    if (!context.holds())
        return context.at("below")
                   ? Text::tr(
                         "%1: End 1 is inside the window, so something is certainly visible. Only "
                         "End 2 remains to be tested.")
                         .arg(beyond)
                   : Text::tr("%1.").arg(beyond);
    if (context.at("right"))
        return Text::tr("%1: the plane will be turned by 180°, so that right becomes left and one "
                        "procedure serves both sides.")
            .arg(beyond);
    if (context.at("above", "below"))
        return Text::tr(
                   "%1, neither left nor right of it: the plane will be turned by 90°, so that "
                   "this side becomes the left one.")
            .arg(beyond);
    if (context.at("leftBelow"))
        return Text::tr("%1, beyond a corner: the plane will be mirrored, so that this becomes the "
                        "corner that the procedure was written for.")
            .arg(beyond);
    return Text::tr("%1.").arg(beyond);
}

QString whereEndTwoIs(const SentenceContext& context)
{
    const QString beyond = words::whetherBeyond(context, 2);
    const bool isBeyond = context.at("notBelow") ? !context.holds() : context.holds();
    if (!isBeyond)
        return Text::tr("%1.").arg(beyond);
    if (context.at("bothLeft", "bothAbove", "edgeBothLeft"))
        return Text::tr("%1, and so does End 1.").arg(beyond);
    if (context.at("notBelow", "edgeBelow"))
        return Text::tr("%1: the line may miss the window there, which is tested next.")
            .arg(beyond);
    if (context.at("edgeAbove"))
        return Text::tr("%1: the plane will be mirrored, so that one procedure serves both sides.")
            .arg(beyond);
    if (context.at("cornerRight", "edgeRight"))
        return Text::tr("%1: the line leaves the window through %2.")
            .arg(beyond, context.edgeText());
    if (context.at("cornerBeyond", "bottomBeyond", "leftTop"))
        return Text::tr("%1: the line could leave through either of two edges.").arg(beyond);
    if (context.at("leftBottom"))
        return Text::tr(
                   "%1: the line could leave through either of two edges. The plane will be turned "
                   "by 90°.")
            .arg(beyond);
    if (context.at("insideRight"))
        return Text::tr("%1: the plane will be turned by 180°, so that right becomes left.")
            .arg(beyond);
    return Text::tr("%1: the line must leave the window.").arg(beyond);
}

/// A test for a corner of the window: which of two products is larger.
struct CornerTest {
    std::string_view label;
    std::string_view first, second;
    int end; ///< the end that lies beyond the corner
    enum { Enters, Leaves, Misses } asks;
};
constexpr std::array cornerTests{
    CornerTest{"cornerSide", "pymax", "pxmin", 1, CornerTest::Enters},
    CornerTest{"cornerMisses", "pymin", "pxmin", 2, CornerTest::Misses},
    CornerTest{"cornerToBottom", "pymin", "pxmax", 2, CornerTest::Leaves},
    CornerTest{"bottomMisses", "pymin", "pxmin", 2, CornerTest::Misses},
    CornerTest{"bottomToBottom", "pymin", "pxmax", 2, CornerTest::Leaves},
    CornerTest{"leftToTop", "pymax", "pxmin", 2, CornerTest::Leaves},
};
const CornerTest* cornerTestOf(const SentenceContext& context)
{
    const auto* const test = std::ranges::find(cornerTests, context.step.label, &CornerTest::label);
    return context.step.what == clipping::What::Test && test != cornerTests.end() ? test : nullptr;
}

/// A comparison of slopes, as products.
QString passesCorner(const SentenceContext& context, const CornerTest& test)
{
    const Corner corner = cornerBeyond(context, test.end);
    const double first = context.known(test.first).value_or(0);
    const double second = context.known(test.second).value_or(0);
    const QString relation = words::compared(first, second);
    const QString through = context.holds() ? corner.edge : corner.other;
    if (!std::isfinite(first) || !std::isfinite(second))
        return words::productsTooLarge(relation, corner.name);
    if (test.asks == CornerTest::Enters)
        return Text::tr("Slopes are compared as products, without a division (%1): the line passes "
                        "%2 on the side of %3. It can enter only there.")
            .arg(relation, corner.name, through);
    if (test.asks == CornerTest::Leaves)
        return Text::tr("By the products for %1 (%2), the line leaves through %3.")
            .arg(corner.name, relation, through);
    if (context.holds())
        return Text::tr("The line passes %1 on the outside (%2): it misses the window.")
            .arg(corner.name, relation);
    return Text::tr(
               "The line passes %1 on the inside (%2): it meets the window and enters through %3.")
        .arg(corner.name, relation, corner.edge);
}

/// One product, or two from one line of the pseudo-code.
QString product(const SentenceContext& context)
{
    const auto& last = context.step.values.back();
    if (context.step.values.size() == 1)
        return Text::tr("One more product, for the next corner: %1 = %2.")
            .arg(latin(last.name), words::number(last.value));
    const auto& first = context.step.values.front();
    return Text::tr("Two products compare the line's slope with that of a corner, without a "
                    "division: %1 = %2, %3 = %4.")
        .arg(latin(first.name), words::number(first.value), latin(last.name),
             words::number(last.value));
}

QString nichollCut(const SentenceContext& context)
{
    const int end = context.at("cornerEnters", "edgeEnters", "bottomEnters") ? 1 : 2;
    return Text::tr("%1 moves along the line to %2, to %3. This end is now known to be visible.")
        .arg(words::end(end), context.edgeText(), words::point(words::endOf(end, context)));
}

QString extent(const SentenceContext& context)
{
    const Point d = context.tracedLine.line.b - context.tracedLine.line.a;
    const bool changed = context.value("dx") != d.x || context.value("dy") != d.y;
    return (changed
                ? Text::tr("From End 1 to End 2, in the plane of this procedure: dx = %1, dy = %2.")
                : Text::tr("From End 1 to End 2: dx = %1, dy = %2."))
        .arg(words::value(context, "dx"), words::value(context, "dy"));
}

/// The ends in the plane that has been rotated or mirrored for a procedure.
QString turned(const SentenceContext& context)
{
    const auto end = [&](const char* x, const char* y) {
        return words::point({context.value(x).value_or(0), context.value(y).value_or(0)});
    };
    return Text::tr(
               "In the plane of this procedure, End 1 is at %1 and End 2 at %2. The picture is not "
               "turned.")
        .arg(end("x1", "y1"), end("x2", "y2"));
}

QString let(const SentenceContext& context)
{
    const auto& name = context.step.name;
    if (name == "display")
        return words::isBeyond(context, 1, context.edge())
                       && words::isBeyond(context, 2, context.edge())
                   ? words::bothBeyond(context)
                   : Text::tr("The line misses the window. No division was needed to decide this.");
    if (name == "dy")
        return extent(context);
    if (name == "ymin")
        return turned(context);
    if (name == "left")
        return Text::tr("The plane is turned back, and the ends with it.");
    return product(context);
}

QString nichollSentence(const SentenceContext& context)
{
    const auto& step = context.step;
    switch (step.what) {
    case clipping::What::Test:
        if (context.at("hidden"))
            return context.holds()
                       ? Text::tr("A test has found that nothing of the line is visible.")
                       : Text::tr("No test has ruled the line out.");
        if (const CornerTest* test = cornerTestOf(context))
            return passesCorner(context, *test);
        return context.at("left", "right", "leftAbove", "leftBelow", "above", "below")
                   ? whereEndOneIs(context)
                   : whereEndTwoIs(context);
    case clipping::What::Reject:
        return Text::tr("Nothing of the line is visible.") + words::lost(context);
    case clipping::What::Cut:
        return nichollCut(context);
    case clipping::What::Accept:
        return words::acceptedIfInside(context);
    default:
        return let(context);
    }
}

/// The line and the window have known values; repeated in a trace, they are those of a rotated
/// plane.
constexpr auto nichollVariables = std::to_array<VariableUnit>({
    {"pxmin", ValueUnit::Area},
    {"pxmax", ValueUnit::Area},
    {"pymin", ValueUnit::Area},
    {"pymax", ValueUnit::Area},
    {"xmin", ValueUnit::Turned},
    {"ymin", ValueUnit::Turned},
    {"xmax", ValueUnit::Turned},
    {"ymax", ValueUnit::Turned},
    {"x1", ValueUnit::Turned},
    {"y1", ValueUnit::Turned},
    {"x2", ValueUnit::Turned},
    {"y2", ValueUnit::Turned},
});

} // namespace

extern const Teaching nichollLeeNichollTeaching;
const Teaching nichollLeeNichollTeaching{
    .key = "nicholl-lee-nicholl",
    .sentence = nichollSentence,
    .overlay = sectorOverlay,
    .figure = {.line = {{-160, -100}, {150, 20}}},
    .variables = nichollVariables,
};

} // namespace app
