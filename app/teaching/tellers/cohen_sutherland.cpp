// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/overlays/family.h"
#include "app/teaching/teaching.h"
#include "app/teaching/tellers/ends.h"

#include <QCoreApplication>

#include <cmath>

namespace app {

using clipping::What;

namespace {

QString tr(const char* text) { return QCoreApplication::translate("tellers", text); }

unsigned known(const Telling& telling, const char* name)
{
    return unsigned(telling.known(name).value_or(0));
}

/// The current outcode of an end.
unsigned codeOf(const Telling& telling, int number)
{
    if (words::isPublished(telling))
        return known(telling, number == 1 ? "code1" : "code2");
    return known(telling, number == 1 ? "code[1]" : "code[2]");
}

QString codeText(const Telling& telling, int number)
{
    return outcodeText(codeOf(telling, number));
}
QString codeAndRegion(const Telling& telling, int number)
{
    return words::codeAndRegion(codeOf(telling, number), telling.specimen.y);
}

/// The end that is cut: End 1 while it is outside.
int endOutside(const Telling& telling)
{
    return words::isPublished(telling) ? (codeOf(telling, 1) != 0 ? 1 : 2)
                                       : int(known(telling, "i"));
}

QString outcodes(const Telling& telling)
{
    return tr("The outcodes say where the ends lie: End 1 has %1, End 2 has %2.")
        .arg(codeAndRegion(telling, 1), codeAndRegion(telling, 2));
}

/// Whether any end is outside.
QString anyOutside(const Telling& telling, bool outside)
{
    const unsigned either = codeOf(telling, 1) | codeOf(telling, 2);
    return (outside ? tr("Not both ends are inside, for %1 | %2 = %3 is not 0000: the line cannot "
                         "be accepted yet.")
                    : tr("Both ends are inside, for %1 | %2 = %3: the line can be accepted."))
        .arg(codeText(telling, 1), codeText(telling, 2), outcodeText(either));
}

/// Whether both ends are beyond one edge.
QString bothBeyond(const Telling& telling)
{
    const unsigned common = codeOf(telling, 1) & codeOf(telling, 2);
    if (!telling.holds())
        return tr("No edge has both ends beyond it, for %1 & %2 = %3: the line cannot be rejected "
                  "yet.")
            .arg(codeText(telling, 1), codeText(telling, 2), outcodeText(common));
    return tr("Both ends lie %4, for %1 & %2 = %3 is not 0000.")
        .arg(codeText(telling, 1), codeText(telling, 2), outcodeText(common),
             words::beyond(words::edgeOf(common), telling.specimen.y));
}

QString rejected(const Telling& telling)
{
    const unsigned common = codeOf(telling, 1) & codeOf(telling, 2);
    return tr("Every point between two ends that lie %1 lies there too: nothing of the line is "
              "visible.")
        .arg(words::beyond(words::edgeOf(common), telling.specimen.y));
}

/// Which end is cut next.
QString chosen(const Telling& telling)
{
    return codeOf(telling, 1) != 0
               ? tr("End 1 is outside, with %1: it is the one to be cut.")
                     .arg(codeAndRegion(telling, 1))
               : tr("End 1 is inside, End 2 is outside, with %1: it is the one to be cut.")
                     .arg(codeAndRegion(telling, 2));
}

/// Whether the end is cut at the step's edge.
QString cutThere(const Telling& telling)
{
    const int number = endOutside(telling);
    const QString code = codeText(telling, number), end = words::end(number);
    if (!telling.holds())
        return tr("The bit of %1 is not set in %2: %3 is not cut there now.")
            .arg(telling.edgeText(), code, end);
    return tr("The bit of %1 is set in %2: %3 lies %4 and is cut there.")
        .arg(telling.edgeText(), code, end, words::beyond(telling.edge(), telling.specimen.y));
}

/// Published form: the point where the line meets the edge.
QString meets(const Telling& telling)
{
    const int along = clipping::axisOf(telling.edge());
    const auto& window = telling.specimen.window;
    const double level = clipping::levelOf(telling.edge(), window);
    const double there = telling.value(along == 0 ? "y" : "x").value_or(0);
    if (!std::isfinite(there))
        return tr("The numbers are too large: their product overflows, %1 becomes %2, and what "
                  "comes of it means nothing any more.")
            .arg(along == 0 ? QStringLiteral("y") : QStringLiteral("x"), words::number(there));
    return tr("From End 1 to %1 it is %2 in %3. There the line is at %4.")
        .arg(telling.edgeText(), words::number(level - telling.step.segment.a[along]),
             words::axisName(telling.edge()),
             words::point(along == 0 ? Point{level, there} : Point{there, level}));
}

/// Corrected form: how far the end moves from its original place.
QString way(const Telling& telling)
{
    const int number = endOutside(telling);
    const auto& line = telling.specimen.line;
    return words::way(telling, words::end(number), number == 1 ? line.a : line.b,
                      telling.value(telling.step.name).value_or(0));
}

QString moved(const Telling& telling)
{
    if (!words::isPublished(telling))
        return words::moved(telling, endOutside(telling));
    const int number = telling.value("code1") ? 1 : 2;
    return words::moved(telling, number) + u' '
           + tr("Its outcode is now %1.").arg(codeAndRegion(telling, number));
}

/// The corrected form's new outcode, before and after the bits of edges that have cut the end are
/// cleared.
QString newCode(const Telling& telling)
{
    const int number = endOutside(telling);
    if (telling.edge() != clipping::Edge::None)
        return tr("The way that %1 has moved, compared with the ways to the other edges, gives the "
                  "outcode %2.")
            .arg(words::end(number), codeAndRegion(telling, number));
    const unsigned done = known(telling, number == 1 ? "done[1]" : "done[2]");
    return tr("An edge that has cut %1 does not cut it again. The bits of these edges, %2, are "
              "left "
              "out, so the outcode is %3.")
        .arg(words::end(number), outcodeText(done), codeAndRegion(telling, number));
}

/// The tests without an edge.
QString decided(const Telling& telling)
{
    const bool published = words::isPublished(telling);
    switch (telling.step.line) {
    case 3:
        return anyOutside(telling, !telling.holds());
    case 4:
        return anyOutside(telling, telling.holds());
    case 5:
        return bothBeyond(telling);
    default:
        return !published        ? chosen(telling)
               : telling.holds() ? tr("The outcode is that of End 1, so End 1 is cut.")
                                 : tr("The outcode is not that of End 1, so End 2 is cut.");
    }
}

QString sentence(const Telling& telling)
{
    const auto what = telling.step.what;
    const auto& name = telling.step.name;
    if (what == What::Accept)
        return words::acceptedIfInside(telling);
    if (what == What::Reject)
        return rejected(telling) + words::lost(telling);
    if (what == What::GiveUp)
        return tr(
            "After 64 cuts no end is in sight: rounding clears one bit and sets another, round and "
            "round. The published form never ends here; it is stopped, and nothing is drawn.");
    if (what == What::Cut)
        return moved(telling);
    if (what == What::Test)
        return telling.edge() == clipping::Edge::None ? decided(telling) : cutThere(telling);
    if (telling.step.line == 1)
        return outcodes(telling);
    if (name == "left")
        return words::held(telling);
    if (name == "codeOut")
        return chosen(telling);
    if (name == "i")
        return tr("%1 is cut from where it was given, %2.")
            .arg(words::end(endOutside(telling)),
                 words::point(endOutside(telling) == 1 ? telling.specimen.line.a
                                                       : telling.specimen.line.b));
    if (name == "x" || name == "y")
        return meets(telling);
    return name == "run" || name == "rise" ? way(telling) : newCode(telling);
}

} // namespace

extern const Teaching cohenSutherlandTeaching;
const Teaching cohenSutherlandTeaching{
    .key = "cohen-sutherland",
    .sentence = sentence,
    .overlay = outcodeOverlay,
    .figure = {.line = {{-170, -120}, {130, 60}}}, // an end is cut twice
};

} // namespace app
