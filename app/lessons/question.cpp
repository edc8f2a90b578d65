// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/question.h"

#include "app/latin.h"

#include <QCryptographicHash>

#include <algorithm>

namespace app {

std::optional<Question> questionOf(const LessonPage& page, const Walk& walk, std::size_t step)
{
    if (!page.question)
        return std::nullopt;
    const auto kinds = questionKinds();
    const auto kind = std::ranges::find_if(
        kinds, [&](const QuestionKind& k) { return latin(k.key) == page.question->kind; });
    if (kind == kinds.end())
        return std::nullopt;
    return kind->ask(page.specimen, walk, step, page.question->words);
}

Question shuffled(Question question)
{
    const QString right = question.choices[question.right];
    std::ranges::sort(question.choices, {}, [&](const QString& choice) {
        return QCryptographicHash::hash(
            (question.prompt + question.reason + choice).toUtf8(),
            QCryptographicHash::Md5); // qHash has another seed each time
    });
    question.right = int(question.choices.indexOf(right));
    return question;
}

} // namespace app
