// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/practice/kinds/kinds.h"
#include "app/teaching/code_line.h"
#include "app/teaching/sentences/code_values.h"

#include <algorithm>

namespace app {

namespace {

qsizetype indentOf(const QString& line)
{
    return std::ranges::find_if(line, [](QChar c) { return c != u' '; }) - line.begin();
}

/// The condition of the test with the values that it compares: "−160 < −100".
QString withNumbers(const MoveContext& context, const QString& condition)
{
    const SentenceContext sentence{context.tracedLine, context.traced(), nullptr,
                                   context.now().variables};
    const CodeValues values(sentence, {});
    return filledIn(chosen(condition, values), values);
}

/// Whether a line lies in what a test's line begins: it is reached only if the test is true.
bool isBelow(int line, int test, const QStringList& code)
{
    for (int k = test + 1; k <= line; ++k)
        if (indentOf(code[k - 1]) <= indentOf(code[test - 1]))
            return false;
    return line > test;
}

void addMistakesOfLines(Move& move, const MoveContext& context, const QString& numbers)
{
    const QStringList& code = context.narration.code;
    const int test = move.line, right = int(move.right);
    const bool holds = context.traced().holds;
    for (int line = 1; line <= int(code.size()); ++line) {
        if (context.code[std::size_t(line) - 1].labels.empty())
            continue; // no answer: Practice says so
        if (line == test)
            addMistake(move, "same", line,
                       Text::tr("That line is being run. Which one follows it?"));
        else if (isBelow(line, test, code) && !holds)
            addMistake(move, "as-if-true", line,
                       Text::tr("That line follows if the test is true. With the numbers: is %1?")
                           .arg(numbers));
        else if (!isBelow(line, test, code) && line > test && holds && isBelow(right, test, code))
            addMistake(move, "as-if-false", line,
                       Text::tr("That line follows if the test is false. With the numbers: is %1?")
                           .arg(numbers));
        else if (line < test)
            addMistake(
                move, "backwards", line,
                Text::tr("That line stands above. Is there a loop, or a procedure, that goes "
                         "back to it now? With the numbers: is %1?")
                    .arg(numbers));
        else
            addMistake(move, "skipped", line,
                       Text::tr("Lines between are skipped. With the numbers: is %1? Then go on "
                                "line by line.")
                           .arg(numbers));
    }
}

std::optional<Move> makeLine(const MoveContext& context)
{
    const int test = context.now().line;
    if (context.traced().what != clipping::What::Test || test == 0
        || context.step + 1 >= context.narration.steps.size())
        return std::nullopt;
    const int next = context.narration.steps[context.step + 1].line;
    const QString condition = conditionIn(context.codeText(test));
    if (next == 0 || next == test || condition.isEmpty())
        return std::nullopt;
    const QString numbers = withNumbers(context, condition);
    Move move{.prompt = Text::tr("Line %1 asks: %2? Which line is next?").arg(test).arg(condition),
              .brief = Text::tr("Next line after line %1").arg(test),
              .right = double(next),
              .hint = Text::tr("Put the numbers into the test: is %1? Then go on line by line.")
                          .arg(numbers)};
    move.line = test;
    move.reason = context.traced().holds
                      ? Text::tr("%1 is true, so line %2 is next.").arg(numbers).arg(next)
                      : Text::tr("%1 is false, so line %2 is next.").arg(numbers).arg(next);
    const auto choices = std::ranges::count_if(
        context.code, [](const clipping::CodeLine& line) { return !line.labels.empty(); });
    move.chance = 1.0 / double(choices);
    addMistakesOfLines(move, context, numbers);
    return move;
}

QString lineAnswerText(const Move&, double answer, YAxis)
{
    return Text::tr("line %1").arg(int(answer));
}

} // namespace

const MoveMaker lineMaker{
    MoveKind::Line, makeLine, lineAnswerText,
    QT_TRANSLATE_NOOP("Text", "You can also click the line in the pseudo-code.")};

} // namespace app
