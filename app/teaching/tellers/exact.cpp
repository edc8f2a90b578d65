// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/overlays/family.h"
#include "app/overlays/half_plane.h"
#include "app/teaching/teaching.h"
#include "app/teaching/tellers/words.h"

#include <QCoreApplication>

#include <array>

namespace app {

using clipping::Edge;

namespace {

QString tr(const char* text) { return QCoreApplication::translate("tellers", text); }

/// An end of the line, and the edges that the line crosses near it.
struct Side {
    Edge x, y;             ///< the edges that the line passes there
    bool beyondX, beyondY; ///< whether the end lies beyond them
};

Side sideOf(const Point& p, Edge x, Edge y, const clipping::Window& w)
{
    return {x, y, isBeyond(p, x, w), isBeyond(p, y, w)};
}
Side entryOf(const Specimen& specimen)
{
    const auto& [a, b] = specimen.line;
    return sideOf(a, a.x < b.x ? Edge::Left : Edge::Right, a.y < b.y ? Edge::Bottom : Edge::Top,
                  specimen.window);
}
Side exitOf(const Specimen& specimen)
{
    const auto& [a, b] = specimen.line;
    return sideOf(b, a.x < b.x ? Edge::Right : Edge::Left, a.y < b.y ? Edge::Top : Edge::Bottom,
                  specimen.window);
}

/// Lines 1 and 3: whether both ends are beyond the same edge of an axis.
QString bothBeyond(const Telling& telling)
{
    const auto axis = telling.step.line == 1 ? 0 : 1;
    const auto beyond = [&](Edge edge) { return words::beyond(edge, telling.specimen.y); };
    if (telling.holds())
        return tr("Both ends lie %1, and so does all between them.").arg(beyond(telling.edge()));
    return tr("The ends lie neither both %1 nor both %2: the line may meet the window.")
        .arg(beyond(clipping::lowerEdge(axis)), beyond(clipping::upperEdge(axis)));
}

/// Line 6: the direction of the line.
QString direction(const Telling& telling)
{
    const auto& [a, b] = telling.specimen.line;
    const auto grows = [&](const char* name) {
        return telling.value(name) == 1.0 ? tr("grows") : tr("does not grow");
    };
    return tr("From End 1 to End 2 x %1 (%2) and y %3 (%4).")
        .arg(grows("right"), words::compared(a.x, b.x), grows("up"), words::compared(a.y, b.y));
}

/// Lines 7 and 8: the near and the far edge of an axis.
QString nearAndFar(const Telling& telling)
{
    const Specimen& specimen = telling.specimen;
    const Side in = entryOf(specimen), out = exitOf(specimen);
    const bool isX = telling.step.name == "xfar";
    return tr("So %1 is near: the line can enter by it. And %2 is far: the line can leave by it.")
        .arg(edgeWords(isX ? in.x : in.y, specimen.y), edgeWords(isX ? out.x : out.y, specimen.y));
}

/// Lines 9 to 12: whether an end is beyond the near or the far edge of an axis.
QString oneBeyond(const Telling& telling)
{
    const int number = telling.step.line <= 10 ? 1 : 2;
    const auto& end = number == 1 ? telling.specimen.line.a : telling.specimen.line.b;
    return (telling.value(telling.step.name) == 1.0 ? tr("%1 is beyond %2 (%3).")
                                                    : tr("%1 is not beyond %2 (%3)."))
        .arg(words::end(number), telling.edgeText(),
             words::compared(end, telling.edge(), telling.specimen.window));
}

/// Lines 13 and 15: whether the line passes the corner between an entry and an exit on the outside.
QString corner(const Telling& telling)
{
    const Specimen& specimen = telling.specimen;
    const Side in = entryOf(specimen), out = exitOf(specimen);
    const bool first = telling.step.line == 13;
    const QString entry = edgeWords(first ? in.x : in.y, specimen.y);
    const QString exit = edgeWords(first ? out.y : out.x, specimen.y);
    if (telling.holds())
        return tr("The line has passed %1 before it reaches %2: it goes round the corner between "
                  "them, outside. That is certain, whatever the rounding.")
            .arg(exit, entry);
    if (first ? in.beyondX && out.beyondY : in.beyondY && out.beyondX)
        return tr("The line reaches %2 no later than %1: the corner between them does not keep it "
                  "out. That is certain, whatever the rounding.")
            .arg(exit, entry);
    return tr("The line need not enter at %2 and leave at %1, so the corner between them cannot "
              "keep "
              "it out.")
        .arg(exit, entry);
}

/// Lines 17, 19, 21 and 23: at which of two edges an end is cut.
QString cutWhere(const Telling& telling)
{
    const Specimen& specimen = telling.specimen;
    const bool entering = telling.step.line < 21;
    const Side side = entering ? entryOf(specimen) : exitOf(specimen);
    const QString end = words::end(entering ? 1 : 2);
    const QString x = edgeWords(side.x, specimen.y), y = edgeWords(side.y, specimen.y);
    const bool asksX = telling.step.line == 17 || telling.step.line == 21;
    if (!asksX)
        return telling.holds() ? tr("%1 is beyond %2: it is cut there.").arg(end, y)
                               : tr("%1 is inside and stays as it is, bit for bit.").arg(end);
    if (!side.beyondX)
        return tr("%1 is not beyond %2.").arg(end, x);
    if (!side.beyondY)
        return tr("%1 is beyond %2 and no other edge: it is cut there.").arg(end, x);
    if (entering)
        return (telling.holds()
                    ? tr("Of the two edges that the line enters by, it passes %1 no earlier than "
                         "%2: End 1 is cut at %1.")
                    : tr("Of the two edges that the line enters by, it passes %2 later than %1: "
                         "End 1 is not cut at %1."))
            .arg(x, y);
    return (telling.holds()
                ? tr("Of the two edges that the line leaves by, it passes %1 no later than %2: "
                     "End 2 is cut at %1.")
                : tr("Of the two edges that the line leaves by, it passes %2 before %1: End 2 is "
                     "not cut at %1."))
        .arg(x, y);
}

QString given(const Telling& telling)
{
    const auto& name = telling.step.name;
    return name == "up"                       ? direction(telling)
           : name == "xfar" || name == "yfar" ? nearAndFar(telling)
                                              : oneBeyond(telling);
}

QString sentence(const Telling& telling)
{
    const int line = telling.step.line;
    const int end = line <= 20 ? 1 : 2;
    switch (telling.step.what) {
    case clipping::What::Accept:
        return words::accepted(telling);
    case clipping::What::Reject:
        return tr("Nothing of the line is visible, and that is certain.");
    case clipping::What::Cut:
        return tr("%1 moves along the line to %2, to %3: the true point, rounded once.")
            .arg(words::end(end), telling.edgeText(),
                 words::point(end == 1 ? telling.step.segment.a : telling.step.segment.b));
    case clipping::What::Test:
        return line <= 3 ? bothBeyond(telling) : line <= 15 ? corner(telling) : cutWhere(telling);
    default:
        return given(telling);
    }
}

constexpr auto variables = std::to_array<VariableUnit>({
    {"xnear", ValueUnit::X},
    {"ynear", ValueUnit::Y},
    {"xfar", ValueUnit::X},
    {"yfar", ValueUnit::Y},
});

} // namespace

extern const Teaching exactTeaching;
const Teaching exactTeaching{
    .key = "exact",
    .sentence = sentence,
    .overlay = turnOverlay,
    .figure = {.line = {{-160, 10}, {-20, 120}}}, // close to a corner
    .variables = variables,
};

} // namespace app
