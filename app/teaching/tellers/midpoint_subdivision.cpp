// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/overlays/family.h"
#include "app/teaching/teaching.h"
#include "app/teaching/tellers/ends.h"

#include <QCoreApplication>

#include <array>

namespace app {

using clipping::What;

namespace {

QString tr(const char* text) { return QCoreApplication::translate("tellers", text); }

unsigned bitsOf(const Telling& telling, const char* name)
{
    return unsigned(telling.known(name).value_or(0));
}
QString codeText(const Telling& telling, const char* name)
{
    return outcodeText(bitsOf(telling, name));
}
QString codeAndRegion(const Telling& telling, const char* name)
{
    return words::codeAndRegion(bitsOf(telling, name), telling.specimen.y);
}
QString numberOf(const Telling& telling, const char* name)
{
    return words::number(telling.known(name).value_or(0));
}

QString outcodes(const Telling& telling)
{
    return tr("The outcodes say where the ends lie: End 1 has %1, End 2 has %2.")
        .arg(codeAndRegion(telling, "code1"), codeAndRegion(telling, "code2"));
}

/// A common bit of two outcodes, as an edge that both points lie beyond.
QString beyondBoth(const Telling& telling, const char* one, const char* other)
{
    return words::beyond(words::edgeOf(bitsOf(telling, one) & bitsOf(telling, other)),
                         telling.specimen.y);
}

/// Line 2: whether both ends are beyond the same edge.
QString bothBeyond(const Telling& telling)
{
    const QString one = codeText(telling, "code1"), two = codeText(telling, "code2");
    return telling.holds()
               ? tr("Both ends lie %3, for %1 & %2 is not 0000.")
                     .arg(one, two, beyondBoth(telling, "code1", "code2"))
               : tr("No edge has both ends beyond it, for %1 & %2 = 0000: the line may meet the "
                    "window.")
                     .arg(one, two);
}

/// Whether an end is outside, so that a search for it is needed.
QString sought(const Telling& telling, int number)
{
    const QString code = codeText(telling, number == 1 ? "code1" : "code2");
    if (telling.holds())
        return tr("%1 is outside (%2): the visible point nearest to it is sought, by halving.")
            .arg(words::end(number), code);
    return number == 1 && telling.known("contact") == 1.0
               ? tr("The line meets the window in one point, which is found.")
               : tr("%1 is inside (%2) and stays.").arg(words::end(number), code);
}

/// Whether the near and the far point share a bit.
QString nearAndFar(const Telling& telling, bool share)
{
    const QString near = codeText(telling, "near"), far = codeText(telling, "far");
    return share ? tr("The near point (%1) and the far point (%2) both lie %3.")
                       .arg(near, far, beyondBoth(telling, "near", "far"))
                 : tr("The near point (%1) and the far point (%2) share no edge: the end that is "
                      "sought lies between them.")
                       .arg(near, far);
}

/// Which half is discarded.
QString halved(const Telling& telling)
{
    const QString code = codeAndRegion(telling, "M");
    return (telling.holds()
                ? tr("The middle, with %1, and the far point lie beyond the same edge: the half "
                     "between them holds nothing and is dropped.")
                : tr("The middle, with %1, shares no edge with the far point: the end that is "
                     "sought lies between them, and the near half is settled."))
        .arg(code);
}

QString rejected(const Telling& telling)
{
    if (telling.step.line == 3)
        return tr("Every point between two ends that lie %1 lies there too: nothing of the line is "
                  "visible.")
            .arg(beyondBoth(telling, "code1", "code2"));
    if (words::isPublished(telling) && telling.step.line == 20)
        return tr("There is nothing left to halve, and the near point is still outside: nothing is "
                  "visible.");
    return tr("Between two points that lie %1 nothing is visible.")
        .arg(beyondBoth(telling, "near", "far"));
}

/// The result of the search for an end.
QString found(const Telling& telling)
{
    const bool published = words::isPublished(telling);
    const int line = telling.step.line;
    const int number = published ? (line == 7 ? 2 : 1) : (line == 12 || line == 23 ? 2 : 1);
    if (!published && (line == 14 || line == 23))
        return tr("%1 is at the same point.").arg(words::end(number));
    return tr("There is nothing left to halve: %1 is found at %2, at %3.")
        .arg(words::end(number), words::point(words::endOf(number, telling)), telling.edgeText());
}

QString publishedTest(const Telling& telling)
{
    switch (telling.step.line) {
    case 2:
        return bothBeyond(telling);
    case 5:
        return sought(telling, 2);
    case 8:
        return sought(telling, 1);
    case 14:
        return nearAndFar(telling, telling.holds());
    case 18:
        return telling.holds()
                   ? tr("The middle is one of the two points: there is nothing left to halve.")
                   : tr("The middle lies between the two points: it halves what is between them.");
    case 19:
        return telling.holds() ? tr("The near point is still outside, with %1.")
                                     .arg(codeAndRegion(telling, "near"))
                               : tr("The near point is inside: it is the end that was sought.");
    default:
        return halved(telling);
    }
}

QString correctedTest(const Telling& telling)
{
    switch (telling.step.line) {
    case 2:
        return bothBeyond(telling);
    case 6:
        return telling.holds() ? tr("Not both ends are inside: the line has to be halved.")
                               : tr("Both ends are inside: there is nothing to be sought.");
    case 9:
        return sought(telling, 2);
    case 13:
        return telling.holds()
                   ? tr("The near point is outside, too, but beyond another edge (%1, not %2): the "
                        "window lies between the two, and the line meets it in one point.")
                         .arg(codeText(telling, "near"), codeText(telling, "far"))
                   : tr("The near point is inside: it is the end that was sought.");
    case 15:
        return sought(telling, 1);
    case 18:
        return telling.holds()
                   ? tr("The two ends are no more than one step apart: they are one "
                        "point.")
                   : tr("The two ends are not neighbours: more than a point is visible.");
    case 22:
        return telling.holds() ? tr("The line meets the window in one point.")
                               : tr("The line meets the window in more than one point.");
    case 27:
        return telling.holds() || (bitsOf(telling, "near") & bitsOf(telling, "far")) != 0
                   ? nearAndFar(telling, !telling.holds())
                   : tr("After %1 halvings nothing is left to halve.")
                         .arg(numberOf(telling, "halvings"));
    case 35:
        return nearAndFar(telling, telling.holds());
    default:
        return halved(telling);
    }
}

/// The assignment of a variable.
QString given(const Telling& telling)
{
    const auto& name = telling.step.name;
    const int line = telling.step.line;
    if (line == 1)
        return outcodes(telling);
    if (name == "ym")
        return tr("The middle of the near and the far point is %1.")
            .arg(words::point({telling.known("xm").value_or(0), telling.known("ym").value_or(0)}));
    if (name == "M")
        return tr("The outcode of the middle is %1.").arg(codeAndRegion(telling, "M"));
    if (name == "contact")
        return line == 5 ? tr("Nothing says yet that the line meets the window in one point only.")
               : telling.known("contact") == 1.0
                   ? tr("The near point is outside, too: the line meets the window in one point.")
                   : tr("The near point is inside: it is the end that was sought.");
    if (name == "toRight" || name == "toTop")
        return name == "toRight" ? tr("From End 1 it is %1 in x to End 2, %2 to xmin, %3 to xmax.")
                                       .arg(numberOf(telling, "dx"), numberOf(telling, "toLeft"),
                                            numberOf(telling, "toRight"))
                                 : tr("From End 1 it is %1 in y to End 2, %2 to ymin, %3 to ymax.")
                                       .arg(numberOf(telling, "dy"), numberOf(telling, "toBottom"),
                                            numberOf(telling, "toTop"));
    if (name == "halvings")
        return telling.value("t") ? tr("The middle lies at t = %1 of the way from End 1 to End 2.")
                                        .arg(numberOf(telling, "t"))
                                  : tr("Nothing has been halved yet.");
    if (name == "s")
        return tr("The end lies at t = %1, on the edges that %2 names.")
            .arg(numberOf(telling, "t"), codeText(telling, "s"));
    if (name == "x" || name == "y")
        return telling.value("x") && telling.value("y")
                   ? tr("There the line is at %1.")
                         .arg(words::point(
                             {telling.known("x").value_or(0), telling.known("y").value_or(0)}))
                   : tr("On its edge, or held inside the window, %1 is %2.")
                         .arg(QLatin1StringView(name.data(), qsizetype(name.size())),
                              words::number(telling.value(name).value_or(0)));
    if (telling.value("near") && telling.value("far"))
        return tr("The near point has the outcode %1, the far point %2.")
            .arg(codeAndRegion(telling, "near"), codeAndRegion(telling, "far"));
    return name == "far"
               ? tr("The middle is now the far point, with %1.").arg(codeAndRegion(telling, "far"))
               : tr("The middle is now the near point, with %1.")
                     .arg(codeAndRegion(telling, "near"));
}

QString sentence(const Telling& telling)
{
    switch (telling.step.what) {
    case What::Accept:
        return words::acceptedIfInside(telling);
    case What::Reject:
        return rejected(telling) + words::lost(telling);
    case What::GiveUp:
        return tr("Halving does not come to an end with these numbers: it is stopped, and nothing "
                  "is visible.");
    case What::Cut:
        return found(telling);
    case What::Test:
        return words::isPublished(telling) ? publishedTest(telling) : correctedTest(telling);
    default:
        return given(telling);
    }
}

constexpr auto variables = std::to_array<VariableUnit>({
    {"f", ValueUnit::Bare},
    {"last", ValueUnit::Bare},
    {"n", ValueUnit::Bare},
    {"toLeft", ValueUnit::Length},
    {"toRight", ValueUnit::Length},
    {"toBottom", ValueUnit::Length},
    {"toTop", ValueUnit::Length},
    {"xf", ValueUnit::X},
    {"yf", ValueUnit::Y},
    {"xm", ValueUnit::X},
    {"ym", ValueUnit::Y},
    {"xn", ValueUnit::X},
    {"yn", ValueUnit::Y},
});

} // namespace

extern const Teaching midpointSubdivisionTeaching;
const Teaching midpointSubdivisionTeaching{
    .key = "midpoint-subdivision",
    .sentence = sentence,
    .parameter = "t",
    .middle = {"xm", "ym"},
    .overlay = midpointOverlay,
    .figure = {.line = {{-40, -10}, {160, 110}}}, // halves without division
    .variables = variables,
};

} // namespace app
