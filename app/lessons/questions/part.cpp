// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/lessons/questions/edge_at.h"

namespace app {

namespace {

/// "ask part": which of the three parts stays of a line that both sides of the window cut.
std::optional<Question> askPart(const TracedLine& tracedLine, const Narration&, std::size_t,
                                const QStringList&)
{
    const auto& [a, b] = tracedLine.line;
    const auto inside = clipped(exactVariant(), tracedLine.line, tracedLine.window);
    if (!inside || inside->a == a || inside->b == b || inside->a == inside->b)
        return std::nullopt; // two parts would leave the second try no choice
    const QString from = edgeWords(edgeAt(inside->a, tracedLine.window), tracedLine.y),
                  to = edgeWords(edgeAt(inside->b, tracedLine.window), tracedLine.y);
    return Question{
        Text::tr("Which part of the line stays?"),
        {Text::tr("From End 1 to %1").arg(from), Text::tr("From %1 to %2").arg(from, to),
         Text::tr("From %1 to End 2").arg(to)},
        1,
        Text::tr("Only this part lies inside the window."),
        Text::tr("Follow the line from End 1 to End 2. Where does it enter the orange rectangle?"),
        {clipping::Segment{a, inside->a}, *inside, clipping::Segment{inside->b, b}}};
}

} // namespace

extern const QuestionKind partQuestion;
const QuestionKind partQuestion{"part", askPart, Covered::AllSteps, 3,
                                QT_TRANSLATE_NOOP("Text", "a line that the window cuts twice")};

} // namespace app
