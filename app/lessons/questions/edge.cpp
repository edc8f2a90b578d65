// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/question.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace app {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("questions", text); }

/// "ask edge": at which edge the line is cut next.
std::optional<Question> ask(const Specimen& specimen, const Walk& walk, std::size_t step,
                            const QStringList&)
{
    const auto from =
        walk.moments.begin() + std::ptrdiff_t(std::min(step + 1, walk.moments.size()));
    const auto cut = std::find_if(from, walk.moments.end(), [](const Moment& moment) {
        return moment.mark == Mark::Cut && moment.edge != clipping::Edge::None;
    });
    if (cut == walk.moments.end())
        return std::nullopt;
    constexpr std::array edges{clipping::Edge::Left, clipping::Edge::Right, clipping::Edge::Bottom,
                               clipping::Edge::Top};
    QStringList choices;
    for (const clipping::Edge edge : edges)
        choices << tr("At %1").arg(edgeWords(edge, specimen.y));
    return Question{tr("At which edge is the line cut next?"), choices,
                    int(std::ranges::find(edges, cut->edge) - edges.begin()),
                    tr("Step %1: %2").arg(cut - walk.moments.begin() + 1).arg(cut->sentence),
                    tr("Read the pseudo-code on from line %1, with the values of the table. Which "
                       "test is the first that holds?")
                        .arg(walk.moments[step].line)};
}

} // namespace

extern const QuestionKind edgeQuestion;
const QuestionKind edgeQuestion{"edge", ask, Covered::LaterSteps};

} // namespace app
