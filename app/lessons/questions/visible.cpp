// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/lessons/question.h"
#include "app/teaching/line_text.h"

#include <glm/geometric.hpp>

namespace app {

namespace {

/// "ask visible": which of four results the line has, according to `exact`.
std::optional<Question> askVisible(const TracedLine& tracedLine, const Narration&, std::size_t,
                                   const QStringList&)
{
    const auto piece = clipped(exactVariant(), tracedLine.line, tracedLine.window);
    const QString reason =
        !piece ? Text::tr("No point of the line lies inside the window.")
        : *piece == tracedLine.line
            ? Text::tr("Both ends lie inside, and a window is convex, so the whole line is inside.")
            : Text::tr("The visible part runs from %1 to %2.")
                  .arg(pairText(shortText(piece->a.x), shortText(piece->a.y)),
                       pairText(shortText(piece->b.x), shortText(piece->b.y)));
    const int cutEnds =
        piece ? (piece->a != tracedLine.line.a) + (piece->b != tracedLine.line.b) : 3;
    return Question{
        Text::tr("How much of this line is visible in the window?"),
        {Text::tr("All of it"), Text::tr("A part: one end is cut"),
         Text::tr("A part: both ends are cut"), Text::tr("Nothing")},
        cutEnds,
        reason,
        Text::tr("Follow the line from End 1 to End 2. Does it meet the orange rectangle? How "
                 "many of its ends lie outside?")};
}

} // namespace

extern const QuestionKind visibleQuestion;
const QuestionKind visibleQuestion{"visible", askVisible, Covered::AllSteps, 4,
                                   QT_TRANSLATE_NOOP("Text", "a line that can be clipped")};

} // namespace app
