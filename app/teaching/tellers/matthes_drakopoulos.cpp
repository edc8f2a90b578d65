// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/tellers/ends.h"

#include <QCoreApplication>

namespace app {

using clipping::Edge;

namespace {

QString tr(const char* text) { return QCoreApplication::translate("tellers", text); }

/// Lines 1 and 3: whether both ends are beyond one edge of an axis.
QString bothBeyond(const Telling& telling)
{
    const auto &a = telling.step.segment.a, &b = telling.step.segment.b;
    const auto& window = telling.specimen.window;
    if (telling.holds())
        return tr("Both ends lie %1: %2 and %3.")
            .arg(words::beyond(telling.edge(), telling.specimen.y),
                 words::compared(a, telling.edge(), window),
                 words::compared(b, telling.edge(), window));
    const int axis = telling.step.line == 3 ? 1 : 0;
    const auto numbers = [&](const QString& text) {
        return text.arg(words::number(a[axis]), words::number(b[axis]),
                        words::number(window.min[axis]), words::number(window.max[axis]));
    };
    return axis == 0 ? numbers(tr("From x = %1 to x = %2 the line lies neither wholly left nor "
                                  "wholly right of the window (%3 to %4): x does not rule it out."))
                     : numbers(tr("From y = %1 to y = %2 the line lies neither wholly above nor "
                                  "wholly below the window (%3 to %4): y does not rule it out."));
}

/// Lines 7, 10, 13 and 16: whether one end is beyond an edge.
QString oneBeyond(const Telling& telling, int number)
{
    const Edge edge = telling.edge();
    const auto& p = number == 1 ? telling.step.segment.a : telling.step.segment.b;
    const QString where = words::beyond(edge, telling.specimen.y), end = words::end(number);
    const auto rise = telling.value("rise"), gap = telling.value("gap");
    if (rise && gap) // the corrected form asks of the way, not of the rounded place
        return (telling.holds()
                    ? tr("On its way %1 has passed %2: it has moved by %3 in y, and %2 was %4 away "
                         "(%5). It lies %6.")
                    : tr("On its way %1 has not passed %2: it has moved by %3 in y, and %2 was %4 "
                         "away (%5). It does not lie %6."))
            .arg(end, telling.edgeText(), words::number(*rise), words::number(*gap),
                 words::compared(*rise, *gap), where);
    const QString numbers = words::compared(p, edge, telling.specimen.window);
    return (telling.holds() ? tr("%1 lies %2 (%3), so it has to move along the line to %4.")
                            : tr("%1 does not lie %2 (%3), so %4 does not cut it."))
        .arg(end, where, numbers, telling.edgeText());
}

/// Lines 8, 11, 14 and 17: how far the line goes on the other axis on its way to the edge.
QString wayTo(const Telling& telling, int number)
{
    const int from = words::isPublished(telling) ? 1 : number;
    const auto& line = telling.specimen.line;
    return words::way(
        telling, words::end(from), from == 1 ? line.a : line.b,
        telling.value(telling.step.what).value_or(0),
        telling.value(telling.step.what == "rise" ? "(y2-y1)/(x2-x1)" : "(x2-x1)/(y2-y1)"));
}

/// Line 19: after both axes, only x can still be outside, and only if the line misses.
QString stillBeyond(const Telling& telling)
{
    const auto &a = telling.step.segment.a, &b = telling.step.segment.b;
    const auto& window = telling.specimen.window;
    if (telling.holds())
        return tr("Both ends have arrived %1 (%2 and %3): the line is taken to pass the window by.")
            .arg(words::beyond(telling.edge(), telling.specimen.y),
                 words::compared(a, telling.edge(), window),
                 words::compared(b, telling.edge(), window));
    return tr("The ends are now at x = %1 and x = %2, neither both left nor both right of the "
              "window: the line has met it.")
        .arg(words::number(a.x), words::number(b.x));
}

QString rejected(const Telling& telling)
{
    if (telling.step.line == 20)
        return tr(
            "Had the line met the window, its ends would have arrived there. Nothing of it is "
            "visible.");
    return tr("Every point between two ends that lie %1 lies there too: nothing of the line is "
              "visible.")
        .arg(words::beyond(telling.edge(), telling.specimen.y));
}

QString accepted(const Telling& telling)
{
    const auto& [a, b] = telling.step.segment;
    const auto& window = telling.specimen.window;
    if (words::isOutside(a, window) || words::isOutside(b, window))
        return tr("%1 lies outside the window, at %2. The last test sees only ends that are out on "
                  "the same side, so the line is drawn all the same: this is wrong.")
            .arg(words::end(words::isOutside(a, window) ? 1 : 2),
                 words::point(words::isOutside(a, window) ? a : b));
    if (telling.before && telling.before->segment != telling.step.segment)
        return tr("Rounding had put an end just outside: it is held inside the window. %1")
            .arg(words::acceptedIfInside(telling));
    return words::acceptedIfInside(telling);
}

QString sentence(const Telling& telling)
{
    const auto& what = telling.step.what;
    const int number = int(telling.value("i").value_or(1));
    if (what == "accept")
        return accepted(telling);
    if (what == "reject")
        return rejected(telling) + words::lost(telling);
    if (what == "cut")
        return words::moved(telling, number);
    if (what == "rise" || what == "run")
        return wayTo(telling, number);
    return telling.step.line == 19  ? stillBeyond(telling)
           : telling.step.line <= 3 ? bothBeyond(telling)
                                    : oneBeyond(telling, number);
}

} // namespace

extern const Teller matthesDrakopoulosTeller;
const Teller matthesDrakopoulosTeller{
    .key = "matthes-drakopoulos", .sentence = sentence, .ends = {"x[1]", "y[1]", "x[2]", "y[2]"}};

} // namespace app
