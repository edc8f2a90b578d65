// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/differing_layer.h"

#include "app/view/stroke_list_builder.h"

#include <algorithm>

namespace app {

using clipping::Clipped;

DifferingLayer differingLayer(const StyleTable& styles, const SceneLines& lines,
                              const SceneFrame& frame, std::span<const FrameLine> differing,
                              const PictureOptions& options)
{
    PaintedPart all(frame, Painted::All), kept(frame, Painted::Kept);
    StrokeListBuilder wholeLines(styles, lines, all, options), parts(styles, lines, kept, options);
    std::vector<Clipped> whole, pieces;
    for (auto line = differing.begin(); line != differing.end();) {
        const std::size_t at = line->block;
        const SceneBlock& block = *lines.blocks()[at];
        const std::size_t chunk = block.chunkOf(line->line), end = block.endOfChunk(chunk);
        whole.clear();
        for (; line != differing.end() && line->block == at && line->line < end; ++line)
            whole.push_back({block.segments[line->line], std::uint32_t(line->line), 0});
        wholeLines.add(at, chunk, whole);
        const Remains remains = kept.remains(at, chunk);
        if (remains == Remains::Whole)
            parts.add(at, chunk, whole);
        if (remains != Remains::Pieces)
            continue;
        pieces.clear();
        std::ranges::copy_if(
            kept.pieces(at, chunk), std::back_inserter(pieces), [&](const Clipped& piece) {
                return std::ranges::binary_search(whole, piece.source, {}, &Clipped::source);
            });
        parts.add(at, chunk, pieces);
    }
    DifferingLayer layer;
    layer.lines.kept = wholeLines.take();
    layer.parts.ghost = layer.lines.kept;
    layer.parts.kept = parts.take();
    return layer;
}

// A pixel at the edge of a line would keep a shadow of it if only the covered part of the pixel
// were painted anew.
void paintAnew(QImage& image, const DifferingLayer& layer, Band band, const RasterOptions& options)
{
    const QImage covered = rasterised(layer.lines, band, options);
    const QImage parts = rasterised(layer.parts, band, options);
    for (int y = 0; y < image.height(); ++y) {
        auto* const to = reinterpret_cast<QRgb*>(image.scanLine(y));
        const auto* const below = reinterpret_cast<const QRgb*>(covered.constScanLine(y));
        const auto* const above = reinterpret_cast<const QRgb*>(parts.constScanLine(y));
        for (int x = 0; x < image.width(); ++x)
            if (below[x] != 0)
                to[x] = above[x];
    }
}

} // namespace app
