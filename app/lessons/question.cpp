// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/question.h"

#include "app/base/text.h"

#include <QCryptographicHash>

#include <algorithm>

namespace app {

namespace {

const QuestionKind* kindOf(const QuestionSpec& question)
{
    const auto kinds = questionKinds();
    const auto kind = std::ranges::find_if(
        kinds, [&](const QuestionKind& k) { return latin(k.key) == question.kind; });
    return kind == kinds.end() ? nullptr : &*kind;
}
const QuestionKind* kindOf(const LessonPage& page)
{
    return page.question ? kindOf(*page.question) : nullptr;
}

} // namespace

std::optional<Question> questionOf(const LessonPage& page, const Narration& narration,
                                   std::size_t step)
{
    const QuestionKind* kind = kindOf(page);
    auto question =
        kind ? kind->ask(page.tracedLine, narration, step, page.question->words) : std::nullopt;
    if (!question)
        return question;
    const bool showsCode = page.shows.code && page.shows.variables;
    if (!page.hint.isEmpty())
        question->hint = page.hint;
    else if (!showsCode && !question->hintWithoutCode.isEmpty())
        question->hint = question->hintWithoutCode;
    return question;
}

int choicesOf(const QuestionSpec& question)
{
    const QuestionKind* kind = kindOf(question);
    return kind ? kind->choices : 0;
}

QString needOf(const QuestionSpec& question)
{
    const QuestionKind* kind = kindOf(question);
    return kind ? Text::tr(kind->needs) : QString();
}

std::size_t stepsShown(const LessonPage& page, std::size_t step)
{
    const QuestionKind* kind = kindOf(page);
    return kind && kind->covered == Covered::LaterSteps ? step + 1 : 0;
}

Question shuffled(Question question)
{
    const QString right = question.choices[question.right];
    std::ranges::sort(question.choices, {}, [&](const QString& choice) {
        return QCryptographicHash::hash(
            (question.prompt + question.reason + choice).toUtf8(),
            QCryptographicHash::Md5); // qHash has another seed in each run
    });
    question.right = int(question.choices.indexOf(right));
    return question;
}

} // namespace app
