// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/overlays/corner_signs.h"
#include "app/overlays/parts.h"
#include "app/teaching/sentences/ends.h"
#include "app/teaching/sentences/part.h"
#include "app/teaching/sentences/words.h"
#include "app/teaching/teaching.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>

namespace app {

using clipping::What;
using words::knownNumber;

namespace {

unsigned skalaKnown(const SentenceContext& context, const char* name)
{
    return unsigned(context.known(name).value_or(0));
}
QString skalaCodeText(const SentenceContext& context, const char* name)
{
    return outcodeText(skalaKnown(context, name));
}
QString edgeOfTable(const SentenceContext& context, unsigned k)
{
    return edgeWords(edgesFromCorners[k % 4], context.tracedLine.y);
}

/// "left" or "right" of the line's direction; if y points down, the sides are swapped.
QString sideOfLine(const SentenceContext& context, bool positive)
{
    return positive == (context.tracedLine.y == YAxis::Up) ? Text::tr("left") : Text::tr("right");
}

/// The numbers that determine the side of a corner: positive if the first is greater.
std::array<double, 2> numbersOf(const SentenceContext& context, unsigned corner)
{
    const auto value = [&](const char* name) { return context.known(name).value_or(0); };
    if (words::isPublished(context))
        return {value("F"), 0};
    return {value(corner < 2 ? "f[0]" : "f[2]"),
            value(corner == 0 || corner == 3 ? "f[3]" : "f[1]")};
}

QString cornerText(const SentenceContext& context, unsigned k)
{
    return words::corner(edgesFromCorners[k], edgesFromCorners[(k + 3) % 4], context.tracedLine.y);
}

/// The side of a corner: c[0] to c[3].
QString cornerSide(const SentenceContext& context)
{
    const auto& name = context.step.name;
    const unsigned k = unsigned(name[2] - '0');
    const QString corner = cornerText(context, k);
    const auto [one, other] = numbersOf(context, k);
    const bool isSet = context.value(name) == 1;
    const QString relation = words::isPublished(context)
                                 ? Text::tr("F = %1").arg(words::number(one))
                                 : words::compared(one, other);
    const QString all = Text::tr("%1, so c[%2] = %3")
                            .arg(relation, QString::number(k), QString::number(isSet ? 1 : 0));
    if (!std::isfinite(one) || !std::isfinite(other))
        return words::productsTooLarge(all, corner);
    if (one == other)
        return (isSet ? Text::tr(
                    "The line passes exactly through %1 (%2): that corner counts as %3 of "
                    "the line.")
                      : Text::tr("The line passes exactly through %1 (%2): in the strict test that "
                                 "corner does not count as %3 of the line."))
            .arg(corner, all, sideOfLine(context, true));
    return Text::tr("Seen along the line from End 1 to End 2, %1 lies on the %2 (%3).")
        .arg(corner, sideOfLine(context, one > other), all);
}

/// The pattern of the corners.
QString skalaPattern(const SentenceContext& context)
{
    const unsigned c = skalaKnown(context, "c");
    const QString text = outcodeText(c);
    if (context.at("flatPattern"))
        return Text::tr("The line runs along a window without area: its direction selects the row "
                        "of the table, c = %1.")
            .arg(text);
    QStringList crossed;
    for (const clipping::Edge edge : crossedEdges(c))
        crossed << edgeWords(edge, context.tracedLine.y);
    if (crossed.size() != 2)
        return Text::tr("The four answers make c = %1: no edge of the window has its corners on "
                        "different sides of the line.")
            .arg(text);
    return Text::tr(
               "The four answers make c = %1, row %2 of the table: the side changes along %3 and "
               "%4. The infinite line crosses exactly these two edges.")
        .arg(text, QString::number(c), crossed[0], crossed[1]);
}

/// The edges in the table.
QString named(const SentenceContext& context)
{
    const unsigned i = skalaKnown(context, "i"), j = skalaKnown(context, "j");
    if (!words::isPublished(context))
        return Text::tr("By the table, the line enters at %1 and leaves at %2.")
            .arg(edgeOfTable(context, i), edgeOfTable(context, j));
    return Text::tr("The table names the two edges: edge %1 is %2, edge %3 is %4.")
        .arg(QString::number(i), edgeOfTable(context, i), QString::number(j),
             edgeOfTable(context, j));
}

/// Published form: at which of the two edges an end is cut.
QString masked(const SentenceContext& context, int end)
{
    const QString code = skalaCodeText(context, end == 1 ? "code1" : "code2");
    const QString mask = skalaCodeText(context, "MASK[c]");
    if (context.holds())
        return Text::
            tr("The outcode of %1, %2, has the bit of %3 (MASK = %4): %1 lies beyond that edge.")
                .arg(words::end(end), code, context.edgeText(), mask);
    return Text::tr(
               "The outcode of %1, %2, does not have the bit of %3 (MASK = %4): %1 lies beyond the "
               "other edge, %5.")
        .arg(words::end(end), code, context.edgeText(), mask,
             edgeOfTable(context, skalaKnown(context, "j")));
}

/// Corrected form: whether an end has to move.
QString isOutside(const SentenceContext& context, int end)
{
    const QString code = skalaCodeText(context, end == 1 ? "code1" : "code2");
    return (context.holds() ? Text::tr("%1 is outside, with the outcode %2, and has to move.")
                            : Text::tr("%1 is inside, with the outcode %2, and stays."))
        .arg(words::end(end), code);
}

/// The tests that only one of the forms has.
QString testOfPublished(const SentenceContext& context)
{
    if (context.at("bothOutside"))
        return context.holds() ? Text::tr("Both ends are outside, so both have to move.")
                               : Text::tr("One end is inside and stays.");
    if (context.at("onlyEnd2"))
        return context.holds() ? Text::tr("End 1 is inside, so it is End 2 that has to move.")
                               : Text::tr("End 1 is outside, so it is the one that has to move.");
    return masked(context, context.at("masked2") ? 2 : 1);
}
QString testOfCorrected(const SentenceContext& context)
{
    if (context.at("allLeft"))
        return context.holds()
                   ? Text::tr("All four bits are set. The line may pass through a corner, so "
                              "each corner is tested again, strictly.")
                   : Text::tr("Not all four bits are set: no corner is tested again.");
    if (context.at("flat"))
        return context.holds()
                   ? Text::tr("All four corners lie on the line: the window has no area.")
                   : Text::tr("Not all four corners lie on the line.");
    return isOutside(context, context.at("end2") ? 2 : 1);
}

QString skalaTest(const SentenceContext& context)
{
    if (context.at("inside"))
        return context.holds()
                   ? Text::tr("Neither outcode has a bit set: both ends are inside.")
                   : Text::tr("At least one outcode has a bit set: that end is outside.");
    if (context.at("beyond"))
        return context.holds()
                   ? Text::tr("The outcodes have a bit in common: both ends lie beyond one edge.")
                   : Text::tr("The outcodes have no bit in common: the line may meet the window.");
    if (context.at("missed"))
        return context.holds()
                   ? Text::tr("With c = %1 all corners count as lying on one side of the line.")
                         .arg(skalaCodeText(context, "c"))
                   : Text::tr(
                       "The corners do not all lie on one side, so the line meets the window.");
    return words::isPublished(context) ? testOfPublished(context) : testOfCorrected(context);
}

/// The line before the corners are tested.
QString line(const SentenceContext& context)
{
    return words::isPublished(context)
               ? Text::tr(
                     "The cross product of both ends is the line as a vector: px = %1, py = %2, pw "
                     "= %3. It tells on which side of the line a point lies.")
                     .arg(knownNumber(context, "px"), knownNumber(context, "py"),
                          knownNumber(context, "pw"))
               : Text::tr(
                     "The line is measured from End 1, so it needs no third number, which could "
                     "lose digits: dx = %1, dy = %2.")
                     .arg(knownNumber(context, "dx"), knownNumber(context, "dy"));
}

/// Corrected form: f[0] and f[1], or f[2] and f[3].
QString products(const SentenceContext& context)
{
    const bool first = context.step.name == "f[1]";
    return Text::tr(
               "Each edge has a product, and the test of a corner compares the products of its two "
               "edges. The product of %1 is %2, that of %3 is %4.")
        .arg(edgeOfTable(context, first ? 0 : 2), knownNumber(context, first ? "f[0]" : "f[2]"),
             edgeOfTable(context, first ? 1 : 3), knownNumber(context, first ? "f[1]" : "f[3]"));
}

/// Published form: the intersection of the line with an edge.
QString meeting(const SentenceContext& context)
{
    const auto& name = context.step.name;
    if (name == "n")
        return Text::tr(
                   "The next point to compute is where the line meets %1, edge %2 of the table.")
            .arg(context.edgeText(), knownNumber(context, "n"));
    if (name == "x")
        return Text::tr(
                   "The cross product of both vectors is the point where the line meets %1, times "
                   "w. Its x is %2.")
            .arg(context.edgeText(), knownNumber(context, "x"));
    if (name == "y")
        return Text::tr("The y of the cross product is %1.").arg(knownNumber(context, "y"));
    if (name == "w")
        return Text::tr("Its third component is w = %1. Dividing x and y by w gives the point.")
            .arg(knownNumber(context, "w"));
    return Text::tr("The line of %1 is a vector too: (%2, %3, %4).")
        .arg(context.edgeText(), knownNumber(context, "ex[n]"), knownNumber(context, "ey[n]"),
             knownNumber(context, "ew[n]"));
}

QString skalaCut(const SentenceContext& context)
{
    const auto& step = context.step;
    const int end = context.at("moveSecond", "move2", "upright2", "level2") ? 2 : 1;
    const QString at = words::point(words::endOf(end, context));
    const Point way = step.segment.b - step.segment.a;
    const Point given = context.tracedLine.line.b - context.tracedLine.line.a;
    if (context.at("moveSecond") && glm::dot(way, given) < 0)
        return Text::
            tr("%1 moves to %2, to %3. The published table does not distinguish the edge where the "
               "line enters from the edge where it leaves, so the two ends are now swapped.")
                .arg(words::end(end), context.edgeText(), at);
    return Text::tr("%1 is outside, so it becomes the point where the line crosses %2: %3.")
        .arg(words::end(end), context.edgeText(), at);
}

QString reject(const SentenceContext& context)
{
    if (context.at("rejectBeyond"))
        return words::bothBeyond(context);
    return Text::tr("The line misses the window: nothing is visible.") + words::lost(context);
}

QString skalaGiven(const SentenceContext& context)
{
    const auto& name = context.step.name;
    if (name == "code2")
        return words::outcodes(context);
    if (name == "pw" || name == "dy")
        return line(context);
    if (name == "F")
        return Text::tr("At %1, F = %2.")
            .arg(cornerText(context, skalaKnown(context, "k")), knownNumber(context, "F"));
    if (name.starts_with("c["))
        return cornerSide(context);
    if (name == "c")
        return skalaPattern(context);
    if (name == "j")
        return named(context);
    return name.starts_with("f[") ? products(context) : meeting(context);
}

QString skalaSentence(const SentenceContext& context)
{
    switch (context.step.what) {
    case What::Test:
        return skalaTest(context);
    case What::Let:
        return skalaGiven(context);
    case What::Cut:
        return skalaCut(context);
    case What::Reject:
        return reject(context);
    default:
        return words::acceptedIfInside(context);
    }
}

constexpr auto skalaVariables = std::to_array<VariableUnit>({
    {"F", ValueUnit::Area},
    {"f[0]", ValueUnit::Area},
    {"f[1]", ValueUnit::Area},
    {"f[2]", ValueUnit::Area},
    {"f[3]", ValueUnit::Area},
    {"ex[i]", ValueUnit::X},
    {"ex[j]", ValueUnit::X},
    {"ey[i]", ValueUnit::Y},
    {"ey[j]", ValueUnit::Y},
    {"px", ValueUnit::Length},
    {"py", ValueUnit::Length},
    {"X[k]", ValueUnit::X},
    {"Y[k]", ValueUnit::Y},
});
/// Lines and points of the published form are vectors of three: x, y and w.
constexpr auto skalaPublishedVariables = std::to_array<VariableUnit>({
    {"ex[n]", ValueUnit::Bare},
    {"ey[n]", ValueUnit::Bare},
    {"ew[n]", ValueUnit::FixedLength},
    {"pw", ValueUnit::FixedArea},
    {"x", ValueUnit::FixedArea},
    {"y", ValueUnit::FixedArea},
    {"w", ValueUnit::Length},
});

} // namespace

extern const Teaching skalaTeaching;
const Teaching skalaTeaching{
    .key = "skala",
    .sentence = skalaSentence,
    .overlay = signOverlay,
    .figure = {.line = {{-170, -20}, {60, 140}}}, // two intersections at once
    .variables = skalaVariables,
    .published = skalaPublishedVariables,
};

} // namespace app
