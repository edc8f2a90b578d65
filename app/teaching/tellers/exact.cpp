// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/tellers/words.h"

#include <QCoreApplication>

namespace app {

using clipping::Edge;

namespace {

QString tr(const char* text) { return QCoreApplication::translate("tellers", text); }

/// An end of the line, and the edges that it has to pass.
struct Side {
    Edge x, y;             ///< those that the line passes there
    bool beyondX, beyondY; ///< whether the end lies beyond them
};

bool isBeyond(const Point& p, Edge edge, const clipping::Window& w)
{
    const double v = p[clipping::axisOf(edge)], level = clipping::levelOf(edge, w);
    return edge == clipping::lowerEdge(clipping::axisOf(edge)) ? v < level : v > level;
}

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

QString endSaid(const Side& side, int number, YAxis y)
{
    const QString end = words::end(number);
    if (side.beyondX && side.beyondY)
        return tr("%1 is beyond %2 and %3").arg(end, edgeWords(side.x, y), edgeWords(side.y, y));
    if (side.beyondX || side.beyondY)
        return tr("%1 is beyond %2").arg(end, edgeWords(side.beyondX ? side.x : side.y, y));
    return tr("%1 is inside").arg(end);
}

Edge commonEdge(const Specimen& specimen)
{
    for (const Edge edge : {Edge::Left, Edge::Right, Edge::Bottom, Edge::Top})
        if (isBeyond(specimen.line.a, edge, specimen.window)
            && isBeyond(specimen.line.b, edge, specimen.window))
            return edge;
    return Edge::None;
}

/// Lines 5 and 6: whether the line passes the corner between an entry and an exit on the outside.
QString corner(const Telling& telling)
{
    const Specimen& specimen = telling.specimen;
    const Side in = entryOf(specimen), out = exitOf(specimen);
    const bool first = telling.step.line == 5;
    const QString entry = edgeWords(first ? in.x : in.y, specimen.y);
    const QString exit = edgeWords(first ? out.y : out.x, specimen.y);
    if (telling.step.what == clipping::What::Reject)
        return tr("The line has passed %1 before it reaches %2: it goes round the corner between "
                  "them, outside. Nothing of it is visible, and that is certain.")
            .arg(exit, entry);
    if (first ? in.beyondX && out.beyondY : in.beyondY && out.beyondX)
        return tr("The line reaches %2 no later than %1: the corner between them does not keep it "
                  "out. That is certain, whatever the rounding.")
            .arg(exit, entry);
    return tr("The line need not come in at %2 and go out at %1, so the corner between them cannot "
              "keep it out.")
        .arg(exit, entry);
}

/// Lines 7, 9, 11 and 13: at which of two edges an end is cut.
QString cutWhere(const Telling& telling)
{
    const Specimen& specimen = telling.specimen;
    const bool entering = telling.step.line < 11;
    const Side side = entering ? entryOf(specimen) : exitOf(specimen);
    const QString end = words::end(entering ? 1 : 2);
    const QString x = edgeWords(side.x, specimen.y), y = edgeWords(side.y, specimen.y);
    const bool asksX = telling.step.line == 7 || telling.step.line == 11;
    if (!asksX)
        return telling.holds() ? tr("%1 is beyond %2: it is cut there.").arg(end, y)
                               : tr("%1 is inside and stays as it is, bit for bit.").arg(end);
    if (!side.beyondX)
        return tr("%1 is not beyond %2.").arg(end, x);
    if (!side.beyondY)
        return tr("%1 is beyond %2 and no other edge: it is cut there.").arg(end, x);
    if (entering)
        return (telling.holds()
                    ? tr("Of the two edges that it enters by, %1 comes after %2: End 1 is cut "
                         "there.")
                    : tr("Of the two edges that it enters by, %2 comes later than %1: it "
                         "is not cut at %1."))
            .arg(x, y);
    return (telling.holds()
                ? tr("Of the two edges that it leaves by, %1 comes before %2: End 2 is cut there.")
                : tr(
                    "Of the two edges that it leaves by, %2 comes before %1: it is not cut at %1."))
        .arg(x, y);
}

QString sentence(const Telling& telling)
{
    const auto what = telling.step.what;
    const int line = telling.step.line;
    const auto& left = telling.step.segment;
    const Specimen& specimen = telling.specimen;
    if (what == clipping::What::Accept)
        return words::accepted(telling);
    if (telling.step.name == "sides")
        return tr("%1; %2.").arg(endSaid(entryOf(specimen), 1, specimen.y),
                                 endSaid(exitOf(specimen), 2, specimen.y));
    if (line == 1)
        return what == clipping::What::Reject
                   ? tr("Both ends lie %1, and so does all between them: nothing of the line is "
                        "visible.")
                         .arg(words::beyond(commonEdge(specimen), specimen.y))
                   : tr("No edge has both ends beyond it, so the line may meet the window.");
    if (what == clipping::What::Cut)
        return tr("%1 moves along the line to %2, to %3: the true point, rounded once.")
            .arg(words::end(line <= 10 ? 1 : 2), telling.edgeText(),
                 words::point(line <= 10 ? left.a : left.b));
    return line <= 6 ? corner(telling) : cutWhere(telling);
}

} // namespace

extern const Teller exactTeller;
const Teller exactTeller{.key = "exact", .sentence = sentence};

} // namespace app
