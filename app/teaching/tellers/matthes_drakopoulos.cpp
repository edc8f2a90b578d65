// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/overlays/family.h"
#include "app/teaching/teaching.h"
#include "app/teaching/tellers/ends.h"

#include <QCoreApplication>

namespace app {

using clipping::Edge;

namespace {

QString tr(const char* text) { return QCoreApplication::translate("tellers", text); }

/// Whether both ends are beyond the same edge of an axis.
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

/// Whether one end is beyond an edge.
QString oneBeyond(const Telling& telling, int number)
{
    const Edge edge = telling.edge();
    const auto& p = number == 1 ? telling.step.segment.a : telling.step.segment.b;
    if (words::asksTheWay(telling))
        return words::whetherPassed(telling, number);
    const QString where = words::beyond(edge, telling.specimen.y), end = words::end(number);
    const QString numbers = words::compared(p, edge, telling.specimen.window);
    return (telling.holds() ? tr("%1 lies %2 (%3), so it has to move along the line to %4.")
                            : tr("%1 does not lie %2 (%3), so %4 does not cut it."))
        .arg(end, where, numbers, telling.edgeText());
}

/// How far the line goes along the other axis on its way to the edge.
QString wayTo(const Telling& telling, int number)
{
    const int from = words::isPublished(telling) ? 1 : number;
    const auto& line = telling.specimen.line;
    const auto [dx, dy] = std::pair(line.b.x - line.a.x, line.b.y - line.a.y);
    const double slope = telling.step.name == "rise" ? dy / dx : dx / dy;
    return words::way(telling, words::end(from), from == 1 ? line.a : line.b,
                      telling.value(telling.step.name).value_or(0),
                      words::isPublished(telling) ? std::optional(slope) : std::nullopt);
}

/// After both axes, only x can still be outside, and only if the line misses the window.
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

/// The last test: on line 19 of the published form, on line 20 of the corrected one.
bool isLastTest(const clipping::Step& step, const Telling& telling)
{
    return step.line == (words::isPublished(telling) ? 19 : 20);
}

QString rejected(const Telling& telling)
{
    if (telling.before && isLastTest(*telling.before, telling))
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
    return words::acceptedIfInside(telling);
}

QString sentence(const Telling& telling)
{
    const auto what = telling.step.what;
    const auto& name = telling.step.name;
    const int number = int(telling.known("i").value_or(1));
    if (what == clipping::What::Accept)
        return accepted(telling);
    if (what == clipping::What::Reject)
        return rejected(telling) + words::lost(telling);
    if (what == clipping::What::Cut)
        return words::moved(telling, number);
    if (name == "dy")
        return tr("From End 1 to End 2 it goes %1 in x and %2 in y.")
            .arg(words::value(telling, "dx"), words::value(telling, "dy"));
    if (name == "moved")
        return tr("%1 is where it was given, at %2: it has not been moved yet.")
            .arg(words::end(number),
                 words::point(number == 1 ? telling.step.segment.a : telling.step.segment.b));
    if (name == "left")
        return words::held(telling);
    if (name == "rise" || name == "run")
        return wayTo(telling, number);
    if (telling.step.line <= 3)
        return bothBeyond(telling);
    return isLastTest(telling.step, telling) ? stillBeyond(telling) : oneBeyond(telling, number);
}

} // namespace

extern const Teaching matthesDrakopoulosTeaching;
const Teaching matthesDrakopoulosTeaching{
    .key = "matthes-drakopoulos",
    .sentence = sentence,
    .overlay = pushOverlay,
};

} // namespace app
