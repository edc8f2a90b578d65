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

/// Lines 5 to 12: what one edge says.
QString asked(const Telling& telling)
{
    const QString edge = telling.edgeText();
    switch (telling.step.line) {
    case 5:
        return (telling.holds()
                    ? tr("D = %2: the line runs along %1 and never crosses it.")
                    : tr("D = %2 is not 0: the line, taken as endless, crosses %1 somewhere."))
            .arg(edge, number(telling, "D"));
    case 6:
        return tr("End 1 is not beyond %1 (N = %2, not less than 0), and neither is the rest of "
                  "the "
                  "line: this edge cuts nothing.")
            .arg(edge, number(telling, "N"));
    case 9:
        return (telling.holds() ? tr("D = %1 is greater than 0: at %2 the line comes in.")
                                : tr("D = %1 is less than 0: at %2 the line goes out."))
            .arg(number(telling, "D"), edge);
    case 10:
        return (telling.holds()
                    ? tr("Of all entries so far, the one at %1 is the last (%2).")
                    : tr("What is left begins no earlier than that (%2): %1 cuts nothing off."))
            .arg(edge, compared(telling, "t", "tE"));
    default:
        return (telling.holds()
                    ? tr("Of all exits so far, the one at %1 is the first (%2).")
                    : tr("What is left ends no later than that (%2): %1 cuts nothing off."))
            .arg(edge, compared(telling, "t", "tL"));
    }
}

/// Lines 14, 15 and 17: what is left when all edges have been asked.
QString concluded(const Telling& telling)
{
    switch (telling.step.line) {
    case 14:
        return tr("The last entry comes no later than the first exit (tE = %1, tL = %2): what lies "
                  "between them is visible.")
            .arg(number(telling, "tE"), number(telling, "tL"));
    case 15:
        return (telling.holds() ? tr("tL = %1 is less than 1: End 2 lies outside and has to move.")
                                : tr("tL = %1: End 2 is inside and stays."))
            .arg(number(telling, "tL"));
    default:
        return (telling.holds()
                    ? tr("tE = %1 is greater than 0: End 1 lies outside and has to move.")
                    : tr("tE = %1: End 1 is inside and stays."))
            .arg(number(telling, "tE"));
    }
}

QString rejected(const Telling& telling)
{
    if (telling.step.line == 6)
        return tr("The line runs along %1, beyond it (N = %2 is less than 0): nothing of it is "
                  "visible.")
            .arg(telling.edgeText(), number(telling, "N"));
    return tr("The line goes out before it comes in (tE > tL: %1): nothing of it is visible.")
        .arg(compared(telling, "tE", "tL"));
}

QString accepted(const Telling& telling)
{
    const auto& [a, b] = telling.step.segment;
    const auto& window = telling.specimen.window;
    const bool flat = window.min.x == window.max.x || window.min.y == window.max.y;
    if (flat && (words::isOutside(a, window) || words::isOutside(b, window)))
        return tr(
            "The window has no area, so two of its normals are (0, 0) and cut nothing. What is "
            "left is taken for visible, and that is wrong: it reaches beyond the window.");
    return words::acceptedIfInside(telling);
}

QString sentence(const Telling& telling)
{
    const auto what = telling.step.what;
    const auto& name = telling.step.name;
    const QString edge = telling.edgeText();
    if (what == clipping::What::Accept)
        return accepted(telling);
    if (what == clipping::What::Reject)
        return rejected(telling) + words::lost(telling);
    if (name == "D")
        return tr("The inner normal of %1 is (%2, %3). Along it the line gains D = %4 on its way "
                  "from "
                  "End 1 to End 2.")
            .arg(edge, number(telling, "nx"), number(telling, "ny"), number(telling, "D"));
    if (name == "N")
        return tr("Along the same normal End 1 lies N = %1 inside %2 (less than 0: beyond it).")
            .arg(number(telling, "N"), edge);
    if (name == "t")
        return tr("The line crosses %1 at t = −N/D = %2 (0 is End 1, 1 is End 2).")
            .arg(edge, number(telling, "t"));
    if (name == "entry")
        return tr("What is left begins at %1, with tE = %2.").arg(edge, number(telling, "tE"));
    if (name == "exit")
        return tr("What is left ends at %1, with tL = %2.").arg(edge, number(telling, "tL"));
    if (name == "cut b")
        return words::moved(telling, 2);
    if (name == "cut a")
        return words::moved(telling, 1);
    return telling.step.line >= 14 ? concluded(telling) : asked(telling);
}

} // namespace

extern const Teller cyrusBeckTeller;
const Teller cyrusBeckTeller{.key = "cyrus-beck", .sentence = sentence, .parameter = "t"};

} // namespace app
