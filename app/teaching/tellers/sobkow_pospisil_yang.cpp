// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/overlays/family.h"
#include "app/teaching/teaching.h"
#include "app/teaching/tellers/ends.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace app {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("sobkow-pospisil-yang", text); }

int endNamed(const Telling& telling) { return telling.known("i") == 2.0 ? 2 : 1; }

/// The script that the code of both regions selects.
QString script(const Telling& telling)
{
    const QString code = words::value(telling, "code");
    return tr("Both outcodes together are the number %1, the code of this pair of regions. The "
              "table has a script for each of the 81 pairs.")
               .arg(code)
           + u' '
           + (telling.value("code") == 0.0
                  ? tr("This one is empty: both ends are inside.")
                  : tr("This one does and asks no more than this pair needs."));
}

/// A test of the script. If the rounded end is on the edge, the distance that it moved decides.
QString question(const Telling& telling)
{
    const int end = endNamed(telling);
    const bool mayReject = telling.step.line <= (words::isPublished(telling) ? 17 : 31);
    QString found = words::whetherBeyond(telling, end);
    if (telling.holds() && !words::isBeyond(telling, end, telling.edge()))
        found = tr("%1 comes to lie on %2 by rounding, but the way it has gone leads beyond it")
                    .arg(words::end(end), telling.edgeText());
    if (mayReject)
        return telling.holds() ? tr("%1, so the line misses the window.").arg(found)
                               : tr("%1: here the line does not miss the window.").arg(found);
    return telling.holds() ? tr("%1: it has to move once more.").arg(found)
                           : tr("%1, so it need not move again.").arg(found);
}

QString tested(const Telling& telling)
{
    if (telling.step.line == 3)
        return telling.holds() ? tr("The script of this pair is a cross: both ends lie beyond one "
                                    "edge.")
                               : tr("The script of this pair is no cross: the line may meet the "
                                    "window.");
    if (!words::isPublished(telling) && telling.step.line == 6)
        return telling.holds() ? tr("The script is not empty: it moves an end.")
                               : tr("The script is empty: no end has to move.");
    return question(telling);
}

/// Where an end would arrive at an edge, before it is clamped.
QString arrival(const Telling& telling)
{
    const int end = endNamed(telling);
    const auto& line = telling.specimen.line;
    const QString name = telling.step.name == "x" ? QStringLiteral("x") : QStringLiteral("y");
    return words::way(telling, words::end(end), end == 1 ? line.a : line.b,
                      telling.value(end == 1 ? "way[1]" : "way[2]").value_or(0))
           + u' ' + tr("There %1 = %2.").arg(name, words::value(telling, telling.step.name));
}

/// Whether rounding has put an end beyond an edge of the other axis.
QString held(const Telling& telling)
{
    const bool isLow = telling.step.line % 4 == 1; // the second line of a procedure
    const auto axis = 1 - clipping::axisOf(telling.edge());
    const auto side = isLow ? clipping::lowerEdge(axis) : clipping::upperEdge(axis);
    const auto name = telling.step.name;
    const auto& values = telling.before->values;
    const auto before = std::ranges::find(values, name, &clipping::NamedValue::name);
    const bool stays = before != values.end() && before->value == telling.value(name);
    return (stays ? tr("Rounding does not take %1 %2: %3 stays.")
                  : tr("Rounding would take %1 %2: %3 is held at the edge."))
        .arg(words::end(endNamed(telling)), words::beyond(side, telling.specimen.y),
             name == "x" ? QStringLiteral("x") : QStringLiteral("y"));
}

QString given(const Telling& telling)
{
    const auto& name = telling.step.name;
    if (name == "code2")
        return words::outcodes(telling);
    if (name == "code")
        return script(telling);
    if (name == "dy")
        return tr("From End 1 to End 2 it goes %1 in x and %2 in y.")
            .arg(words::value(telling, "dx"), words::value(telling, "dy"));
    return telling.step.line % 4 == 0 ? arrival(telling) : held(telling);
}

QString cut(const Telling& telling)
{
    const int end = endNamed(telling);
    return tr("%1 is beyond %2, so it moves along the line to that edge, to %3.")
        .arg(words::end(end), telling.edgeText(), words::point(words::endOf(end, telling)));
}

QString sentence(const Telling& telling)
{
    switch (telling.step.what) {
    case clipping::What::Test:
        return tested(telling);
    case clipping::What::Cut:
        return cut(telling);
    case clipping::What::Reject:
        return telling.step.line == 4
                   ? words::bothBeyond(telling)
                   : tr("The line passes a corner outside the window: nothing of it is visible.")
                         + words::lost(telling);
    case clipping::What::Accept:
        return words::acceptedIfInside(telling);
    default:
        return given(telling);
    }
}

constexpr auto variables = std::to_array<VariableUnit>({
    {"way[1]", ValueUnit::Length},
    {"way[2]", ValueUnit::Length},
});

} // namespace

extern const Teaching sobkowPospisilYangTeaching;
const Teaching sobkowPospisilYangTeaching{
    .key = "sobkow-pospisil-yang",
    .sentence = sentence,
    .overlay = scriptOverlay,
    .figure = {.line = {{-150, 40}, {20, -120}}},
    .variables = variables,
};

} // namespace app
