// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/tellers/ends.h"

#include <QCoreApplication>

namespace app {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("tellers", text); }

QString codeText(const Telling& telling, const char* name)
{
    return outcodeText(words::bits(telling, name));
}

/// Lines 12 and 13: which half is dropped.
QString halved(const Telling& telling)
{
    const bool drops = telling.step.line == 12;
    const auto t = telling.value("t");
    const auto& [near, far] = telling.step.segment;
    const QString where = t ? tr("at t = %1").arg(words::number(*t))
                            : tr("at %1").arg(words::point(drops ? far : near));
    const QString code = words::codeAndRegion(words::bits(telling, "M"), telling.specimen.y);
    return (drops ? tr("The middle, %1, has the outcode %2 and lies beyond the same edge as the "
                       "far point: the half between them holds nothing and is dropped.")
                  : tr("The middle, %1, has the outcode %2 and shares no edge with the far point: "
                       "the end that is sought lies between them, and the near half is settled."))
        .arg(where, code);
}

QString outcodes(const Telling& telling)
{
    const auto y = telling.specimen.y;
    return tr("The outcodes say where the ends lie: End 1 has %1, End 2 has %2.")
        .arg(words::codeAndRegion(words::bits(telling, "code1"), y),
             words::codeAndRegion(words::bits(telling, "code2"), y));
}

QString rejected(const Telling& telling)
{
    if (telling.step.line == 2)
        return tr("Both ends lie %3, for %1 & %2 is not 0000, and so does all between them: "
                  "nothing of the line is visible.")
            .arg(codeText(telling, "code1"), codeText(telling, "code2"),
                 words::beyond(
                     words::edgeOf(words::bits(telling, "code1") & words::bits(telling, "code2")),
                     telling.specimen.y));
    if (telling.step.line == 9)
        return tr("The near point (%1) and the far point (%2) lie beyond the same edge: between "
                  "them nothing is visible.")
            .arg(codeText(telling, "near"), codeText(telling, "far"));
    return tr(
        "There is nothing left to halve, and the near point is still outside: nothing is visible.");
}

/// Lines 2, 3 and 5.
QString asked(const Telling& telling)
{
    if (telling.step.line == 2)
        return tr("No edge has both ends beyond it, for %1 & %2 = 0000: the line may meet the "
                  "window.")
            .arg(codeText(telling, "code1"), codeText(telling, "code2"));
    const int number = telling.step.line == 3 ? 2 : 1;
    const QString code = codeText(telling, number == 1 ? "code1" : "code2");
    return (telling.holds()
                ? tr("%1 is outside (%2): the visible point nearest to it is sought, by halving.")
                : tr("%1 is inside (%2) and stays."))
        .arg(words::end(number), code);
}

QString sentence(const Telling& telling)
{
    const auto what = telling.step.what;
    const auto& name = telling.step.name;
    if (what == clipping::What::Accept)
        return words::acceptedIfInside(telling);
    if (what == clipping::What::Reject)
        return rejected(telling) + words::lost(telling);
    if (name == "outcodes")
        return outcodes(telling);
    if (name == "halve")
        return halved(telling);
    if (what == clipping::What::GiveUp)
        return tr("Halving does not come to an end with these numbers: it is stopped, and nothing "
                  "is visible.");
    if (what == clipping::What::Cut) {
        const int number = telling.step.line == 4 ? 2 : 1;
        return tr("There is nothing left to halve: %1 is found at %2, at %3.")
            .arg(words::end(number),
                 words::point(number == 1 ? telling.step.segment.a : telling.step.segment.b),
                 telling.edgeText());
    }
    return asked(telling);
}

} // namespace

extern const Teller midpointSubdivisionTeller;
const Teller midpointSubdivisionTeller{
    .key = "midpoint-subdivision", .sentence = sentence, .parameter = "t"};

} // namespace app
