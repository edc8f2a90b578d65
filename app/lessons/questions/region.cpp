// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/lessons/question.h"
#include "clipping/outcode.h"

namespace app {

namespace {

/// "beyond the top edge and the left edge"; "inside the window".
QString whereabouts(unsigned code, YAxis y)
{
    QStringList beyond;
    for (const clipping::Edge edge :
         {clipping::Edge::Top, clipping::Edge::Bottom, clipping::Edge::Right, clipping::Edge::Left})
        if (code >> (unsigned(edge) - 1) & 1U)
            beyond << edgeWords(edge, y);
    return beyond.isEmpty() ? Text::tr("inside the window")
                            : Text::tr("beyond %1").arg(beyond.join(Text::tr(" and ")));
}

/// "ask region 2": which outcode End 2 has. Wrong choices swap left and right, or above and below.
std::optional<Question> askRegion(const TracedLine& tracedLine, const Narration&, std::size_t,
                                  const QStringList& words)
{
    if (words.size() != 1 || (words[0] != u'1' && words[0] != u'2'))
        return std::nullopt;
    const Point& end = words[0] == u'1' ? tracedLine.line.a : tracedLine.line.b;
    const unsigned code = clipping::outcodeOf(end, tracedLine.window);
    QStringList choices{outcodeText(code)};
    for (const unsigned other : {(code & 3U) << 2 | code >> 2, code ^ (code & 3U ? 3U : 1U),
                                 code ^ (code & 12U ? 12U : 8U), 0U, 1U, 8U, 5U})
        if (const QString text = outcodeText(other); (other & 3U) != 3 && (other & 12U) != 12
                                                     && !choices.contains(text)
                                                     && choices.size() < 4)
            choices << text;
    return shuffled(
        {Text::tr("Which outcode does End %1 have?").arg(words[0]), choices, 0,
         Text::tr("End %1 lies %2: %3.")
             .arg(words[0], whereabouts(code, tracedLine.y), outcodeText(code)),
         Text::tr("Ask one question for each bit, in this order: %1. A yes is 1, a no is 0.")
             .arg(outcodeBits())});
}

} // namespace

extern const QuestionKind regionQuestion;
const QuestionKind regionQuestion{"region", askRegion, Covered::AllSteps, 4,
                                  QT_TRANSLATE_NOOP("Text", "the number of an end, 1 or 2")};

} // namespace app
