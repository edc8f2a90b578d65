// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/tellers/ends.h"

#include <QCoreApplication>

namespace app {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("tellers", text); }

QString number(const Telling& telling, const char* name)
{
    return words::number(telling.value(name).value_or(0));
}

QString compared(const Telling& telling, const char* one, const char* other)
{
    return words::compared(telling.value(one).value_or(0), telling.value(other).value_or(0));
}

/// Lines 5, 10 and 15: how the line runs at one edge.
QString direction(const Telling& telling)
{
    const QString edge = telling.edgeText(), p = number(telling, "p"), q = number(telling, "q");
    if (telling.step.line == 15)
        return tr("End 1 lies on the inner side of %1 (q = %2, not less than 0), and so does all "
                  "of "
                  "the line: this edge cuts nothing.")
            .arg(edge, q);
    if (telling.step.line == 10)
        return (telling.holds() ? tr("p = %1 is greater than 0: at %2 the line goes out.")
                                : tr("p = %1: the line runs along %2 and never crosses it."))
            .arg(p, edge);
    return (telling.holds() ? tr("p = %1 is less than 0: at %2 the line comes in.")
                            : tr("p = %1 is not less than 0: at %2 the line does not come in."))
        .arg(p, edge);
}

/// Lines 7, 8, 12 and 13: what a crossing changes.
QString crossing(const Telling& telling)
{
    const QString edge = telling.edgeText();
    switch (telling.step.line) {
    case 7:
        return tr("It comes in before it goes out (%1), so something may be left.")
            .arg(compared(telling, "r", "u1"));
    case 12:
        return tr("It goes out after it has come in (%1), so something may be left.")
            .arg(compared(telling, "r", "u0"));
    case 8:
        return (telling.holds() ? tr("Of all entries so far, the one at %1 is the last (%2).")
                                : tr("The part that is left begins later than that (%2): %1 cuts "
                                     "nothing off."))
            .arg(edge, compared(telling, "r", "u0"));
    default:
        return (telling.holds() ? tr("Of all exits so far, the one at %1 is the first (%2).")
                                : tr("The part that is left ends before that (%2): %1 cuts nothing "
                                     "off."))
            .arg(edge, compared(telling, "r", "u1"));
    }
}

QString rejected(const Telling& telling)
{
    const QString edge = telling.edgeText();
    switch (telling.step.line) {
    case 7:
        return tr("It would come in at %1 only after it has gone out at another edge (%2): nothing "
                  "of "
                  "the line is visible.")
            .arg(edge, compared(telling, "r", "u1"));
    case 12:
        return tr("It has gone out at %1 before it comes in at another edge (%2): nothing of the "
                  "line "
                  "is visible.")
            .arg(edge, compared(telling, "r", "u0"));
    default:
        return tr("The line runs along %1, on the outer side of it (q = %2 is less than 0): "
                  "nothing "
                  "of it is visible.")
            .arg(edge, number(telling, "q"));
    }
}

/// Lines 16 and 18: whether an end has to move.
QString needed(const Telling& telling)
{
    if (telling.step.line == 16)
        return (telling.holds() ? tr("u1 = %1 is less than 1: End 2 lies outside and has to move.")
                                : tr("u1 = %1: End 2 is inside and stays."))
            .arg(number(telling, "u1"));
    return (telling.holds() ? tr("u0 = %1 is greater than 0: End 1 lies outside and has to move.")
                            : tr("u0 = %1: End 1 is inside and stays."))
        .arg(number(telling, "u0"));
}

QString sentence(const Telling& telling)
{
    const auto what = telling.step.what;
    const auto& name = telling.step.name;
    const QString edge = telling.edgeText();
    if (what == clipping::What::Accept)
        return words::acceptedIfInside(telling);
    if (what == clipping::What::Reject)
        return rejected(telling) + words::lost(telling);
    if (name == "p and q")
        return tr("The line goes out across %1 at the rate p = %2 (less than 0: it comes in), and "
                  "End 1 "
                  "lies q = %3 inside (less than 0: outside).")
            .arg(edge, number(telling, "p"), number(telling, "q"));
    if (name == "r")
        return (telling.step.line == 6
                    ? tr("The line enters across %1 at r = q/p = %2 (0 is End 1, 1 is End 2).")
                    : tr("The line leaves across %1 at r = q/p = %2 (0 is End 1, 1 is End 2)."))
            .arg(edge, number(telling, "r"));
    if (name == "start")
        return tr("What is left begins at %1, with u0 = %2.").arg(edge, number(telling, "u0"));
    if (name == "stop")
        return tr("What is left ends at %1, with u1 = %2.").arg(edge, number(telling, "u1"));
    if (name == "cut b")
        return words::moved(telling, 2);
    if (name == "cut a")
        return words::moved(telling, 1);
    const int line = telling.step.line;
    return line >= 16                              ? needed(telling)
           : line == 5 || line == 10 || line == 15 ? direction(telling)
                                                   : crossing(telling);
}

} // namespace

extern const Teller liangBarskyTeller;
const Teller liangBarskyTeller{.key = "liang-barsky", .sentence = sentence, .parameter = "r"};

} // namespace app
