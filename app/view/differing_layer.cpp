// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/differing_layer.h"

#include "app/view/stroke_list_builder.h"

#include <QPainter>

#include <algorithm>

namespace app {

using clipping::Clipped;

/// The strokes that are left of some lines in a frame.
static DrawList keptOf(const StyleTable& styles, const SceneLines& lines, const SceneFrame& frame,
                       std::span<const FrameLine> some, const PictureOptions& options)
{
    PaintedPart kept(frame, Painted::Kept);
    StrokeListBuilder list(styles, lines, kept, options);
    std::vector<std::uint32_t> ofChunk; // lines
    std::vector<Clipped> pieces;
    for (auto line = some.begin(); line != some.end();) {
        const std::size_t at = line->block;
        const SceneBlock& block = *lines.blocks()[at];
        const std::size_t chunk = block.chunkOf(line->line), end = block.endOfChunk(chunk);
        ofChunk.clear();
        for (; line != some.end() && line->block == at && line->line < end; ++line)
            ofChunk.push_back(std::uint32_t(line->line));
        pieces.clear();
        const Remains remains = kept.remains(at, chunk);
        if (remains == Remains::Whole)
            for (const std::uint32_t whole : ofChunk)
                pieces.push_back({block.segments[whole], whole, 0});
        else if (remains == Remains::Pieces)
            std::ranges::copy_if(kept.pieces(at, chunk), std::back_inserter(pieces),
                                 [&](const Clipped& piece) {
                                     return std::ranges::binary_search(ofChunk, piece.source);
                                 });
        list.add(at, chunk, pieces);
    }
    return list.take();
}

DifferingLayer differingLayer(const StyleTable& styles, const SceneLines& lines,
                              const SceneFrame& row, const SceneFrame& exact,
                              std::span<const FrameLine> differing, const PictureOptions& options)
{
    DifferingLayer layer;
    layer.shown.kept = keptOf(styles, lines, row, differing, options);
    layer.shown.ghost = keptOf(styles, lines, exact, differing, options);
    layer.removed.kept = layer.shown.ghost;
    return layer;
}

/// A pixel without a line that covers `covered` of 255 of it. What shows through lines is the
/// product of what shows through each, in whatever order they lie above each other.
static QRgb without(QRgb pixel, int covered)
{
    constexpr int rounding = 3;
    const int alpha = qAlpha(pixel);
    if (covered == 0)
        return pixel;
    if (alpha <= covered + rounding)
        return 0; // it was there alone
    const int left = std::clamp(255 - (255 - alpha) * 255 / (255 - covered), 0, alpha);
    const auto scaled = [&](int channel) { return (channel * left + alpha / 2) / alpha; };
    return qRgba(scaled(qRed(pixel)), scaled(qGreen(pixel)), scaled(qBlue(pixel)), left);
}

void paintAnew(QImage& image, const DifferingLayer& layer, Band band, const RasterOptions& options)
{
    const QImage removed = rasterised(layer.removed, band, options);
    for (int y = 0; y < image.height(); ++y) {
        auto* const to = reinterpret_cast<QRgb*>(image.scanLine(y));
        const auto* const by = reinterpret_cast<const QRgb*>(removed.constScanLine(y));
        for (int x = 0; x < image.width(); ++x)
            if (by[x] != 0)
                to[x] = without(to[x], qAlpha(by[x]));
    }
    QPainter(&image).drawImage(0, 0, rasterised(layer.shown, band, options));
}

} // namespace app
