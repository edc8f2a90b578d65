// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/question.h"

#include "app/latin.h"

#include <QHash>

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
    std::size_t seed = qHash(question.prompt + question.choices.join(u'|'), 2019);
    for (qsizetype last = question.choices.size() - 1; last > 0; --last) {
        question.choices.swapItemsAt(last, qsizetype(seed % std::size_t(last + 1)));
        seed = seed / std::size_t(last + 1) + 97 * std::size_t(last);
    }
    question.right = int(question.choices.indexOf(right));
    return question;
}

} // namespace app
