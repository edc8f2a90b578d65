// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/tellers/ends.h"
#include "clipping/outcode.h"

#include <QCoreApplication>

namespace app {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("sobkow-pospisil-yang", text); }

int endNamed(const Telling& telling) { return telling.value("i") == 2.0 ? 2 : 1; }

QString script(const Telling& telling)
{
    const auto codeOf = [&](const Point& p) {
        return clipping::outcodeOf(p, telling.specimen.window);
    };
    const auto& [a, b] = telling.specimen.line;
    return (codeOf(a) | codeOf(b)) == 0
               ? tr(
                   "The table has a script for each of the 81 pairs of regions. This one is empty: "
                   "both ends are inside.")
               : tr("The table has a script for each of the 81 pairs of regions; it does and asks "
                    "no more than this pair needs.");
}

/// A question of the script. Where the rounded end is on the edge, the way it has gone decides.
QString question(const Telling& telling)
{
    const int end = endNamed(telling);
    const bool mayReject = telling.step.line <= 12;
    QString found = words::whetherBeyond(telling, end);
    if (telling.holds() && !words::isBeyond(telling, end, telling.edge()))
        found = tr("%1 comes to lie on %2 by rounding, but the way it has gone leads beyond it")
                    .arg(words::end(end), telling.edgeText());
    if (mayReject)
        return telling.holds() ? tr("%1, and that is past the window.").arg(found)
                               : tr("%1: here the line does not miss the window.").arg(found);
    return telling.holds() ? tr("%1: it has to move once more.").arg(found)
                           : tr("%1: it is where it belongs.").arg(found);
}

QString cut(const Telling& telling)
{
    const int end = endNamed(telling);
    return tr("%1 is beyond %2, so it moves along the line to that edge, to %3.")
        .arg(words::end(end), telling.edgeText(), words::point(words::endOf(end, telling)));
}

QString sentence(const Telling& telling)
{
    const auto what = telling.step.what;
    const auto& name = telling.step.name;
    const int line = telling.step.line;
    if (what == clipping::What::Test)
        return line != 3         ? question(telling)
               : telling.holds() ? tr("The script of this pair is a cross: both ends lie beyond "
                                      "one edge.")
                                 : tr("The script of this pair is no cross: the line may meet the "
                                      "window.");
    if (name == "outcodes")
        return words::outcodes(telling);
    if (name == "script")
        return script(telling);
    if (what == clipping::What::Cut)
        return cut(telling);
    if (what == clipping::What::Reject)
        return line == 3
                   ? words::bothBeyond(telling)
                   : tr("The line passes a corner outside the window: nothing of it is visible.")
                         + words::lost(telling);
    return words::acceptedIfInside(telling);
}

} // namespace

extern const Teller sobkowPospisilYangTeller;
const Teller sobkowPospisilYangTeller{"sobkow-pospisil-yang", sentence};

} // namespace app
