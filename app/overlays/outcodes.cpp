// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/outcode_text.h"
#include "app/overlays/parts.h"

#include <QCoreApplication>

namespace app {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("Overlay", text); }

QString caption(const Seeing& seeing, std::span<const EndMove> moves)
{
    if (!seeing.line)
        return tr("An outcode has four bits: %1. %2").arg(outcodeBits(), pointAtALine());
    QString text = codeWords(seeing);
    if (moves.empty())
        return text;
    text += QStringLiteral(" ")
            + tr("%1 is cut at %2 first.")
                  .arg(endName(moves.front().ofB), edgeWords(moves.front().edge, seeing.y));
    if (seeing.trace.outcome == clipping::Outcome::DidNotEnd)
        text += QStringLiteral(" ") + tr("Its outcodes repeat forever: the algorithm is stopped.");
    return text;
}

} // namespace

Overlay outcodeOverlay(const Seeing& seeing)
{
    Overlay overlay{.areas = outcodeRegions(seeing), .lines = regionBorders(seeing)};
    std::vector<EndMove> moves;
    if (seeing.line) {
        moves = movesOf(seeing.trace, *seeing.line);
        constexpr std::size_t enough = 4; // no form that ends has more
        if (moves.size() > enough)
            moves.resize(enough);
        const auto [a, b] = codesOf(seeing);
        for (OverlayLine& line : moveLines(seeing, moves))
            overlay.lines.push_back(std::move(line));
        overlay.marks = moveMarks(seeing, moves);
        for (OverlayMark& mark : endMarks(*seeing.line, outcodeText(a), outcodeText(b)))
            overlay.marks.push_back(std::move(mark));
        overlay.table = codeTable(seeing);
    }
    overlay.caption = caption(seeing, moves);
    return overlay;
}

} // namespace app
