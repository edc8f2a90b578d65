// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/lessons/question.h"

#include <algorithm>
#include <array>

namespace app {

namespace {

/// The kinds of next steps that can be asked for, in words: not steps that only look or compare.
struct Event {
    Mark mark;
    const char* words;
};
constexpr std::array events{
    Event{Mark::Cut, QT_TRANSLATE_NOOP("Text", "It cuts the line")},
    Event{Mark::Accept, QT_TRANSLATE_NOOP("Text", "It accepts the line or its remaining part")},
    Event{Mark::Reject, QT_TRANSLATE_NOOP("Text", "It rejects the line")},
    Event{Mark::Divide, QT_TRANSLATE_NOOP("Text", "It divides to find where the line may be cut")}};

/// "ask next": which step follows, not counting comparisons.
std::optional<Question> askNext(const TracedLine&, const Narration& narration, std::size_t step,
                                const QStringList&)
{
    for (std::size_t i = step + 1; i < narration.steps.size(); ++i) {
        const NarratedStep& narrated = narration.steps[i];
        const auto event = std::ranges::find(events, narrated.mark, &Event::mark);
        if (event == events.end())
            continue;
        QStringList choices;
        for (const Event& other : events)
            choices << Text::tr(other.words);
        return Question{
            Text::tr("Which step follows, not counting comparisons?"),
            choices,
            int(event - events.begin()),
            narrated.sentence,
            Text::tr("Read the pseudo-code from line %1 on, with the values in the table.")
                .arg(narration.steps[step].line),
            {},
            Text::tr("Follow the tests of the algorithm in their order, with the values of this "
                     "line.")};
    }
    return std::nullopt;
}

} // namespace

extern const QuestionKind nextQuestion;
const QuestionKind nextQuestion{
    "next", askNext, Covered::LaterSteps, 4,
    QT_TRANSLATE_NOOP("Text", "a step that is followed by a division, a cut or a decision; choose "
                              "an earlier one with “:: step”")};

} // namespace app
