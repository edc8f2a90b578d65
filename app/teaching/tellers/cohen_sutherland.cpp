// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/tellers/ends.h"

#include <QCoreApplication>

namespace app {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("tellers", text); }

QString withCodes(const Telling& telling, const QString& text, unsigned result)
{
    return text.arg(outcodeText(words::bits(telling, "code1")),
                    outcodeText(words::bits(telling, "code2")), outcodeText(result));
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
    const unsigned common = words::bits(telling, "code1") & words::bits(telling, "code2");
    return withCodes(telling,
                     tr("Both ends lie %4, for %1 & %2 = %3, and so does all between them: nothing "
                        "of the line is visible."),
                     common)
        .arg(words::beyond(words::edgeOf(common), telling.specimen.y));
}

QString asked(const Telling& telling)
{
    const unsigned one = words::bits(telling, "code1"), two = words::bits(telling, "code2");
    if (telling.step.line == 3)
        return withCodes(telling,
                         tr("Not both ends are inside, for %1 | %2 = %3 is not 0000: the line "
                            "cannot be accepted yet."),
                         one | two);
    if (telling.step.line == 4)
        return withCodes(telling,
                         tr("No edge has both ends beyond it, for %1 & %2 = %3: the line cannot be "
                            "rejected yet."),
                         one & two);
    return tr("The first bit that is set in %1 is the one for %2: %3 lies %4 and is cut there.")
        .arg(outcodeText(words::bits(telling, "code")), telling.edgeText(),
             words::end(int(telling.value("i").value_or(1))),
             words::beyond(telling.edge(), telling.specimen.y));
}

QString chosen(const Telling& telling)
{
    const QString code = words::codeAndRegion(words::bits(telling, "code"), telling.specimen.y);
    return (telling.value("i") == 1.0
                ? tr("End 1 is outside, with %1: it is the one to be cut.")
                : tr("End 1 is inside, End 2 is outside, with %1: it is the one to be cut."))
        .arg(code);
}

QString sentence(const Telling& telling)
{
    const auto what = telling.step.what;
    const auto& name = telling.step.name;
    const int number = int(telling.value("i").value_or(1));
    if (what == clipping::What::Accept)
        return words::acceptedIfInside(telling);
    if (what == clipping::What::Reject)
        return rejected(telling) + words::lost(telling);
    if (what == clipping::What::GiveUp)
        return tr(
            "After 64 cuts no end is in sight: rounding clears one bit and sets another, round and "
            "round. The published form never ends here; it is stopped, and nothing is drawn.");
    if (name == "outcodes")
        return outcodes(telling);
    if (name == "end")
        return chosen(telling);
    if (what == clipping::What::Cut)
        return words::moved(telling, number);
    if (name == "outcode")
        return tr("There %1 has the outcode %2.")
            .arg(words::end(number),
                 words::codeAndRegion(words::bits(telling, number == 1 ? "code1" : "code2"),
                                      telling.specimen.y));
    if (name == "run" || name == "rise") {
        const auto& left =
            words::isPublished(telling) ? telling.step.segment : telling.specimen.line;
        const int from = words::isPublished(telling) ? 1 : number;
        return words::way(telling, words::end(from), from == 1 ? left.a : left.b,
                          telling.value(name).value_or(0));
    }
    return asked(telling);
}

} // namespace

extern const Teller cohenSutherlandTeller;
const Teller cohenSutherlandTeller{.key = "cohen-sutherland", .sentence = sentence};

} // namespace app
