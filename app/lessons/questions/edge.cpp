// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/lessons/question.h"

#include <algorithm>
#include <array>

namespace app {

namespace {

/// "ask edge": at which edge the line is cut next.
std::optional<Question> askEdge(const TracedLine& tracedLine, const Narration& narration,
                                std::size_t step, const QStringList&)
{
    const auto from =
        narration.steps.begin() + std::ptrdiff_t(std::min(step + 1, narration.steps.size()));
    const auto cut = std::find_if(from, narration.steps.end(), [](const NarratedStep& narrated) {
        return narrated.mark == Mark::Cut && narrated.edge != clipping::Edge::NoEdge;
    });
    if (cut == narration.steps.end())
        return std::nullopt;
    constexpr std::array edges{clipping::Edge::Left, clipping::Edge::Right, clipping::Edge::Bottom,
                               clipping::Edge::Top};
    QStringList choices;
    for (const clipping::Edge edge : edges)
        choices << Text::tr("At %1").arg(edgeWords(edge, tracedLine.y));
    return Question{
        Text::tr("At which edge is the line cut next?"),
        choices,
        int(std::ranges::find(edges, cut->edge) - edges.begin()),
        cut->sentence,
        Text::tr("Read the pseudo-code from line %1 on, with the values in the table. Which "
                 "test is the first to be true?")
            .arg(narration.steps[step].line),
        {edges.begin(), edges.end()},
        Text::tr("Follow the tests of the algorithm in their order, with the values of this line. "
                 "Which is the first to be true?")};
}

} // namespace

extern const QuestionKind edgeQuestion;
const QuestionKind edgeQuestion{
    "edge", askEdge, Covered::LaterSteps, 4,
    QT_TRANSLATE_NOOP(
        "Text",
        "a step that is followed by a cut at an edge; choose an earlier one with “:: step”")};

} // namespace app
