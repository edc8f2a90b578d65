// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/lessons/questions/edge_at.h"

#include <algorithm>
#include <array>
#include <utility>

namespace app {

namespace {

using Pair = std::pair<clipping::Edge, clipping::Edge>;

bool isCorner(const Point& p, const clipping::Window& w)
{
    return (p.x == w.min.x || p.x == w.max.x) && (p.y == w.min.y || p.y == w.max.y);
}

/// "ask edges": at which two edges the window cuts the line. Wrong choices have one of them, too,
/// as far as there are such.
std::optional<Question> askEdges(const TracedLine& tracedLine, const Narration&, std::size_t,
                                 const QStringList&)
{
    using clipping::Edge;
    constexpr std::array<Pair, 6> pairs{{{Edge::Left, Edge::Right},
                                         {Edge::Left, Edge::Bottom},
                                         {Edge::Left, Edge::Top},
                                         {Edge::Right, Edge::Bottom},
                                         {Edge::Right, Edge::Top},
                                         {Edge::Bottom, Edge::Top}}};
    const auto inside = clipped(exactVariant(), tracedLine.line, tracedLine.window);
    if (!inside || inside->a == tracedLine.line.a || inside->b == tracedLine.line.b)
        return std::nullopt;
    const Edge in = edgeAt(inside->a, tracedLine.window),
               out = edgeAt(inside->b, tracedLine.window);
    const auto right = std::ranges::find(pairs, Pair{std::min(in, out), std::max(in, out)});
    if (right == pairs.end() || isCorner(inside->a, tracedLine.window)
        || isCorner(inside->b, tracedLine.window)) // two answers are right
        return std::nullopt;
    const auto words = [&](const Pair& pair) {
        return Text::tr("%1 and %2")
            .arg(edgeWords(pair.first, tracedLine.y), edgeWords(pair.second, tracedLine.y));
    };
    QStringList choices{words(*right)};
    for (const Pair& pair : pairs)
        if (pair != *right && choices.size() < 4
            && (pair.first == right->first || pair.second == right->second))
            choices << words(pair);
    for (const Pair& pair : pairs)
        if (const QString text = words(pair); choices.size() < 4 && !choices.contains(text))
            choices << text;
    return shuffled({Text::tr("Which edges does the line cross?"), choices, 0,
                     Text::tr("The line enters at %1 and leaves at %2.")
                         .arg(edgeWords(in, tracedLine.y), edgeWords(out, tracedLine.y)),
                     Text::tr("On which side of the line is each corner? An edge whose corners are "
                              "on different sides is crossed.")});
}

} // namespace

extern const QuestionKind edgesQuestion;
const QuestionKind edgesQuestion{"edges", askEdges, Covered::AllSteps, 4,
                                 QT_TRANSLATE_NOOP("Text", "a line that the window cuts twice")};

} // namespace app
