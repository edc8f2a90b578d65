// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/teaching/code_line.h"
#include "app/teaching/manual.h"
#include "app/teaching/sentences/code_values.h"
#include "app/teaching/sentences/ends.h"
#include "app/teaching/sentences/words.h"
#include "clipping/pseudo_code.h"

#include <algorithm>

// The sentences of an algorithm without its own: its pseudo-code, with numbers.

namespace app {

using clipping::What;

namespace {

QString evenly(const QString& formula)
{
    return withTexts(formula, [](const QString& name) { return name; });
}

/// "At the left edge, " before a sentence about an edge.
QString atEdge(const SentenceContext& context, const QString& said)
{
    const QString edge = context.edgeText();
    return edge.isEmpty() ? said : Text::tr("At %1, %2").arg(edge, said);
}

QString withCapital(QString sentence)
{
    sentence[0] = sentence[0].toUpper();
    return sentence;
}

QString lineOf(const SentenceContext& context, const QStringList& code)
{
    const Variant& variant = context.tracedLine.variant;
    const auto lines = clipping::linesOf(clipping::codeOf(rowOf(variant), variant.form));
    return code.value(clipping::lineOf(lines, context.step.label) - 1);
}

QString asked(const SentenceContext& context, const QStringList& code)
{
    const CodeValues values(context, {});
    const QString condition = chosen(conditionIn(lineOf(context, code)), values);
    if (condition.isEmpty())
        return withCapital(atEdge(context, context.holds() ? Text::tr("the test holds.")
                                                           : Text::tr("the test fails.")));
    const QString question = evenly(condition), numbers = filledIn(condition, values),
                  answer = context.holds() ? Text::tr("yes") : Text::tr("no");
    return withCapital(atEdge(
        context, numbers == question ? Text::tr("is %1? %2.").arg(question, answer)
                                     : Text::tr("is %1? %2: %3.").arg(question, numbers, answer)));
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
QStringList assignments(const SentenceContext& context, const QStringList& code)
{
    const auto all = assignmentsIn(lineOf(context, code), code);
    QStringList said;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const CodeValues after(context, {});
        const auto value = after.of(all[i].name);
        const bool isTold = std::ranges::any_of(context.step.values, [&](const auto& told) {
            return value && latin(told.name) == value->name;
        });
        if (!isTold)
            continue;
        QStringList later; // these are not assigned yet
        for (std::size_t j = all[i].isParameter ? 0 : i; j < all.size(); ++j)
            if (const auto other = after.of(all[j].name); other && (j >= i || all[j].isParameter))
                later << other->name;
        said << setTo(value->name,
                      {evenly(all[i].formula), filledIn(all[i].formula, CodeValues(context, later)),
                       textOf(*value, Digits::Six)});
    }
    return said;
}

/// All values of the step, for a line that does not show how they are computed.
QStringList values(const SentenceContext& context)
{
    QStringList said;
    for (const auto& told : context.step.values)
        said << setTo(latin(told.name),
                      {textOf({latin(told.name), told.value, told.kind}, Digits::Six)});
    return said;
}

const clipping::Segment& leftBefore(const SentenceContext& context)
{
    return context.before ? context.before->segment : context.tracedLine.line;
}

QString whatIsLeft(const SentenceContext& context)
{
    const auto& now = context.step.segment;
    return (now == leftBefore(context)
                ? Text::tr("The remaining part does not change: it runs from %1 to %2.")
                : Text::tr("The remaining part now runs from %1 to %2."))
        .arg(words::point(now.a), words::point(now.b));
}

QString cut(const SentenceContext& context)
{
    const auto& before = leftBefore(context);
    const auto& now = context.step.segment;
    const QString edge = context.edgeText(), a = words::point(now.a), b = words::point(now.b);
    if (before.a != now.a && before.b != now.b)
        return Text::tr("Both ends are cut: End 1 moves to %1, End 2 to %2.").arg(a, b);
    if (before == now)
        return edge.isEmpty()
                   ? Text::tr("The line is cut where an end already lies: nothing moves.")
                   : Text::tr("The line is cut at %1, where an end already lies: nothing moves.")
                         .arg(edge);
    const QString end = words::end(before.a != now.a ? 1 : 2), to = before.a != now.a ? a : b;
    return edge.isEmpty() ? Text::tr("%1 is cut: it moves to %2.").arg(end, to)
                          : Text::tr("%1 is cut at %2: it moves to %3.").arg(end, edge, to);
}

QString given(const SentenceContext& context, const QStringList& code)
{
    if (context.step.name == "left")
        return whatIsLeft(context);
    QStringList said = assignments(context, code);
    if (said.isEmpty())
        said = values(context);
    return atEdge(context, said.join(QStringLiteral(", ")) + u'.');
}

} // namespace

QString generalSentence(const SentenceContext& context)
{
    const QStringList code = codeOf(context.tracedLine.variant);
    switch (context.step.what) {
    case What::Test:
        return asked(context, code);
    case What::Let:
        return given(context, code);
    case What::Cut:
        return cut(context);
    case What::Accept:
        return words::acceptedIfInside(context);
    case What::Reject:
        return Text::tr("The line is rejected: nothing is visible.") + words::lost(context);
    default:
        return Text::tr(
            "The algorithm does not end on this line: it is stopped, and nothing is visible.");
    }
}

} // namespace app
