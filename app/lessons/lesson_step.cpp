// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/lesson_step.h"

#include "app/lessons/lesson.h"

#include <algorithm>
#include <array>

namespace app {

namespace {

/// The step that a page shows: the index among all steps, or among those with a mark, from 1.
struct WantedStep {
    std::optional<Mark> mark;
    std::size_t which;
};

/// "first", "last", "7"; "cut", or "cut-2" for the second cut. Empty for any other word.
std::optional<WantedStep> stepOf(const QString& word)
{
    struct Row {
        const char* word;
        WantedStep step;
    };
    static constexpr std::size_t beyondAll = -1;
    static constexpr std::array rows{
        Row{"", {{}, 1}},
        Row{"first", {{}, 1}},
        Row{"last", {{}, beyondAll}},
        Row{"look", {Mark::Look, 1}},
        Row{"compare", {Mark::Compare, 1}},
        Row{"divide", {Mark::Divide, 1}},
        Row{"cut", {Mark::Cut, 1}},
        Row{"accept", {Mark::Accept, 1}},
        Row{"reject", {Mark::Reject, 1}},
    };
    bool isNumber = false;
    if (const uint number = word.toUInt(&isNumber); isNumber)
        return number > 0 ? std::optional(WantedStep{{}, number}) : std::nullopt;
    const QStringList parts = word.split(u'-');
    const auto row = std::ranges::find_if(
        rows, [&](const Row& r) { return parts[0] == QLatin1StringView(r.word); });
    if (row == rows.end() || parts.size() > 2)
        return std::nullopt;
    if (parts.size() == 1)
        return row->step;
    const uint which = parts[1].toUInt(&isNumber);
    return row->step.mark && isNumber && which > 0
               ? std::optional(WantedStep{row->step.mark, which})
               : std::nullopt;
}

} // namespace

bool isLessonStep(const QString& word) { return stepOf(word).has_value(); }

std::optional<std::size_t> stepFor(const LessonPage& page, const Narration& narration)
{
    const auto wanted = stepOf(page.step);
    const std::size_t count = narration.steps.size();
    if (!wanted || count == 0)
        return std::nullopt;
    if (page.step == u"last")
        return count - 1;
    std::size_t left = wanted->which;
    for (std::size_t i = 0; i < count; ++i)
        if ((!wanted->mark || narration.steps[i].mark == *wanted->mark) && --left == 0)
            return i;
    return std::nullopt;
}

std::size_t wantedStep(const LessonPage& page, const Narration& narration)
{
    return stepFor(page, narration).value_or(std::max<std::size_t>(narration.steps.size(), 1) - 1);
}

} // namespace app
