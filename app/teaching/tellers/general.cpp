// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/latin.h"
#include "app/teaching/code_line.h"
#include "app/teaching/page.h"
#include "app/teaching/tellers/code_values.h"
#include "app/teaching/tellers/ends.h"

#include <QCoreApplication>

#include <algorithm>

// The sentences of an algorithm without its own: its pseudo-code, with numbers.

namespace app {

using clipping::What;

namespace {

QString tr(const char* text) { return QCoreApplication::translate("tellers", text); }

QString evenly(const QString& formula)
{
    return withTexts(formula, [](const QString& name) { return name; });
}

/// "At the left edge, " before a sentence about an edge.
QString atEdge(const Telling& telling, const QString& said)
{
    const QString edge = telling.edgeText();
    return edge.isEmpty() ? said : tr("At %1, %2").arg(edge, said);
}

QString withCapital(QString sentence)
{
    sentence[0] = sentence[0].toUpper();
    return sentence;
}

QString lineOf(const Telling& telling, const QStringList& code)
{
    return code.value(telling.step.line - 1);
}

QString asked(const Telling& telling, const QStringList& code)
{
    const CodeValues values(telling, {});
    const QString condition = chosen(conditionIn(lineOf(telling, code)), values);
    if (condition.isEmpty())
        return withCapital(
            atEdge(telling, telling.holds() ? tr("the test holds.") : tr("the test fails.")));
    const QString question = evenly(condition), numbers = filledIn(condition, values),
                  answer = telling.holds() ? tr("yes") : tr("no");
    return withCapital(atEdge(telling, numbers == question
                                           ? tr("is %1? %2.").arg(question, answer)
                                           : tr("is %1? %2: %3.").arg(question, numbers, answer)));
}

/// "dx = x2 - x1 = 70 - (-160) = 230", without repetition.
QString setTo(const QString& name, const QStringList& texts)
{
    QStringList said{name};
    for (const QString& text : texts)
        if (said.last() != text)
            said << text;
    return said.join(QStringLiteral(" = "));
}

/// The assignments of the line, as far as this step reports them.
QStringList assignments(const Telling& telling, const QStringList& code)
{
    const auto all = assignmentsIn(lineOf(telling, code), code);
    QStringList said;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const CodeValues after(telling, {});
        const auto value = after.of(all[i].name);
        const bool isTold = std::ranges::any_of(telling.step.values, [&](const auto& told) {
            return value && latin(told.name) == value->name;
        });
        if (!isTold)
            continue;
        QStringList later; // these are not assigned yet
        for (std::size_t j = all[i].isParameter ? 0 : i; j < all.size(); ++j)
            if (const auto other = after.of(all[j].name); other && (j >= i || all[j].isParameter))
                later << other->name;
        said << setTo(value->name,
                      {evenly(all[i].formula), filledIn(all[i].formula, CodeValues(telling, later)),
                       textOf(*value, Digits::Six)});
    }
    return said;
}

/// All values of the step, for a line that does not show how they are computed.
QStringList values(const Telling& telling)
{
    QStringList said;
    for (const auto& told : telling.step.values)
        said << setTo(latin(told.name),
                      {textOf({latin(told.name), told.value, told.kind}, Digits::Six)});
    return said;
}

const clipping::Segment& leftBefore(const Telling& telling)
{
    return telling.before ? telling.before->segment : telling.specimen.line;
}

QString whatIsLeft(const Telling& telling)
{
    const auto& now = telling.step.segment;
    return (now == leftBefore(telling) ? tr("What is left stays as it is, from %1 to %2.")
                                       : tr("What is left now runs from %1 to %2."))
        .arg(words::point(now.a), words::point(now.b));
}

QString cut(const Telling& telling)
{
    const auto& before = leftBefore(telling);
    const auto& now = telling.step.segment;
    const QString edge = telling.edgeText(), a = words::point(now.a), b = words::point(now.b);
    if (before.a != now.a && before.b != now.b)
        return tr("Both ends are cut: End 1 moves to %1, End 2 to %2.").arg(a, b);
    if (before == now)
        return edge.isEmpty() ? tr("The line is cut where an end lies already: nothing moves.")
                              : tr("The line is cut at %1, where an end lies already: nothing "
                                   "moves.")
                                    .arg(edge);
    const QString end = words::end(before.a != now.a ? 1 : 2), to = before.a != now.a ? a : b;
    return edge.isEmpty() ? tr("%1 is cut: it moves to %2.").arg(end, to)
                          : tr("%1 is cut at %2: it moves to %3.").arg(end, edge, to);
}

QString given(const Telling& telling, const QStringList& code)
{
    if (telling.step.name == "left")
        return whatIsLeft(telling);
    QStringList said = assignments(telling, code);
    if (said.isEmpty())
        said = values(telling);
    return atEdge(telling, said.join(QStringLiteral(", ")) + u'.');
}

} // namespace

QString generalSentence(const Telling& telling)
{
    const QStringList code = codeOf(telling.specimen.variant);
    switch (telling.step.what) {
    case What::Test:
        return asked(telling, code);
    case What::Let:
        return given(telling, code);
    case What::Cut:
        return cut(telling);
    case What::Accept:
        return words::acceptedIfInside(telling);
    case What::Reject:
        return tr("The line is rejected: nothing of it is visible.") + words::lost(telling);
    default:
        return tr(
            "The algorithm does not end on this line: it is stopped, and nothing is visible.");
    }
}

} // namespace app
