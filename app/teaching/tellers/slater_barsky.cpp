// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/tellers/ends.h"

#include <QCoreApplication>

namespace app {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("slater-barsky", text); }

/// The walk goes to the right; an end of the given line is where it begins.
bool isSwapped(const Telling& telling)
{
    return telling.specimen.line.a.x > telling.specimen.line.b.x;
}
int first(const Telling& telling) { return isSwapped(telling) ? 2 : 1; }
int last(const Telling& telling) { return isSwapped(telling) ? 1 : 2; }

QString order(const Telling& telling)
{
    const QString relation = words::compared(telling.specimen.line.a.x, telling.specimen.line.b.x);
    if (telling.step.name == "swap")
        return tr("The walk begins at End 2, so a is End 2 and b is End 1; the result will be "
                  "turned round again.");
    return telling.holds() ? tr("End 2 lies further left than End 1 (%1), and the walk always goes "
                                "to the right.")
                                 .arg(relation)
                           : tr("End 1 does not lie right of End 2 (%1): the walk begins at End 1, "
                                "so a is End 1 and b is End 2.")
                                 .arg(relation);
}

/// 0 to 8 as a place: "the middle cell", "the cell left of it".
QString cellText(const Telling& telling, int cell)
{
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
    return tr("The error term e = %1 tells on which side of the corner ahead the line passes, "
              "without a division.")
        .arg(words::value(telling, "e"));
}

/// By which side the walk leaves a cell: it goes to the right, and rises at line 22.
QString leaving(const Telling& telling)
{
    const double e = telling.value("e").value_or(0);
    const bool rises = (telling.step.line == 22) == (telling.specimen.y == YAxis::Up);
    const QString relation = words::compared(e, 0);
    if (e == 0)
        return tr("The line goes right through the corner ahead (e = 0): the walk goes on over the "
                  "line of %1.")
            .arg(telling.edgeText());
    if (!telling.holds())
        return tr("By the sign of e (%1) the line passes left of the corner ahead: the walk goes "
                  "on over the line of %2.")
            .arg(relation, telling.edgeText());
    return (rises
                ? tr("By the sign of e (%1) the line passes below the corner ahead: the walk goes "
                     "on to the right, over the line of %2.")
                : tr("By the sign of e (%1) the line passes above the corner ahead: the walk goes "
                     "on to the right, over the line of %2."))
        .arg(relation, telling.edgeText());
}

QString insideTest(const Telling& telling)
{
    if (telling.step.line == 14)
        return telling.holds()
                   ? tr("The walk begins in the middle cell, and the other end is there, too.")
                   : tr("Not both ends are inside the window, so the walk has to show what is.");
    return telling.holds() ? tr("%1 is inside: the walk is over.").arg(words::end(last(telling)))
                           : tr("%1 is not inside: the walk goes on, out of the window again.")
                                 .arg(words::end(last(telling)));
}

QString test(const Telling& telling)
{
    const int line = telling.step.line;
    switch (line) {
    case 1:
        return order(telling);
    case 14:
    case 31:
        return insideTest(telling);
    case 16:
        return telling.holds()
                   ? tr("The line runs along an axis: no division is needed to clip it.")
                   : tr("The line runs along no axis.");
    case 22:
    case 23:
        return leaving(telling);
    default:
        return tr("%1.").arg(words::whetherBeyond(
            telling, line == 4 || line == 8 || line == 11 ? last(telling) : first(telling)));
    }
}

QString cut(const Telling& telling)
{
    const auto& step = telling.step;
    if (step.line == 17)
        return tr("Both ends are held inside the window: what is left goes from %1 to %2.")
            .arg(words::point(step.segment.a), words::point(step.segment.b));
    const bool enters = step.line == 29 || step.line == 30;
    const int end = enters ? first(telling) : last(telling);
    const QString at = words::point(words::endOf(end, telling));
    return enters ? tr("Here the walk comes into the window: %1 moves to %2, to %3.")
                        .arg(words::end(end), telling.edgeText(), at)
                  : tr("Here the walk leaves the window: %1 moves to %2, to %3.")
                        .arg(words::end(end), telling.edgeText(), at);
}

QString reject(const Telling& telling)
{
    if (telling.step.line < 27)
        return words::bothBeyond(telling);
    return tr("From here the walk can only go away from the window: nothing of the line is "
              "visible.")
           + words::lost(telling);
}

QString sentence(const Telling& telling)
{
    const auto what = telling.step.what;
    const auto& name = telling.step.name;
    if (what == clipping::What::Test)
        return test(telling);
    if (name == "swap")
        return order(telling);
    if (name == "cell")
        return tr("%1 is in cell %2, %3: the walk begins there.")
            .arg(words::end(first(telling)), words::value(telling, "cell"),
                 cellText(telling, int(telling.value("cell").value_or(4))));
    if (name == "dx, dy")
        return tr("How far it is from %1 to %2: dx = %3, dy = %4.")
            .arg(words::end(first(telling)), words::end(last(telling)), words::value(telling, "dx"),
                 words::value(telling, "dy"));
    if (name == "e")
        return errorTerm(telling);
    if (name == "next cell")
        return tr("The walk is in cell %1 now, %2. The next corner ahead gives e = %3.")
            .arg(words::value(telling, "cell"),
                 cellText(telling, int(telling.value("cell").value_or(4))),
                 words::value(telling, "e"));
    if (what == clipping::What::Cut)
        return cut(telling);
    if (what == clipping::What::Reject)
        return reject(telling);
    return words::acceptedIfInside(telling);
}

} // namespace

extern const Teller slaterBarskyTeller;
const Teller slaterBarskyTeller{"slater-barsky", sentence};

} // namespace app
