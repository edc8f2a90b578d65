// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/comparison/line_class.h"
#include "app/overlays/parts.h"

namespace app {

namespace {

QString outcodesCaption(const OverlayContext& context, std::span<const EndMove> moves)
{
    if (!context.line)
        return Text::tr("An outcode has four bits: %1. %2").arg(outcodeBits(), pointAtALine());
    QString text = codeWords(context);
    if (moves.empty())
        return text;
    text += QStringLiteral(" ")
            + Text::tr("%1 is cut at %2 first.")
                  .arg(endName(moves.front().ofB), edgeWords(moves.front().edge, context.y));
    if (context.trace.outcome == clipping::Outcome::DidNotEnd)
        text += QStringLiteral(" ")
                + Text::tr("Its outcodes repeat forever: the algorithm is stopped.");
    return text;
}

} // namespace

Overlay outcodeOverlay(const OverlayContext& context)
{
    Overlay overlay{.areas = outcodeRegions(context), .lines = regionBorders(context)};
    std::vector<EndMove> moves;
    if (context.line) {
        moves = movesOf(context.trace, *context.line);
        constexpr std::size_t enough = 4; // no form that ends has more
        if (moves.size() > enough)
            moves.resize(enough);
        const auto [a, b] = codesOf(context);
        for (OverlayLine& line : moveLines(context, moves))
            overlay.lines.push_back(std::move(line));
        overlay.marks = moveMarks(context, moves);
        for (OverlayMark& mark : endMarks(*context.line, outcodeText(a), outcodeText(b)))
            overlay.marks.push_back(std::move(mark));
        overlay.table = codeTable(context);
    }
    overlay.caption = outcodesCaption(context, moves);
    return overlay;
}

} // namespace app
