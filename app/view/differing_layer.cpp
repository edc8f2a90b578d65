// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/differing_layer.h"

#include "app/view/stroke_list_builder.h"

#include <QPainter>

#include <algorithm>
#include <optional>
#include <utility>

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

namespace {

/// An image as it was, and how much of each pixel is removed from it.
class Removing {
public:
    /// `widest`: of the strokes that are removed, in pixels.
    Removing(QImage& image, const QImage& removed, double widest)
        : image_(image), removed_(removed), far_(int(std::clamp(2 * widest, 12.0, 100.0)))
    {
    }

    void remove()
    {
        const int width = image_.width();
        for (int y = 0; y < image_.height(); ++y) {
            auto* const to = reinterpret_cast<QRgb*>(image_.scanLine(y));
            const auto* const by = reinterpret_cast<const QRgb*>(removed_.constScanLine(y));
            for (int x = 0; x < width; ++x)
                if (const int covered = qAlpha(by[x]); covered > 0)
                    to[x] = covered >= complete ? around(x, y) : without(to[x], covered);
        }
    }

private:
    static constexpr int rounding = 3, complete = 255 - rounding;

    static QRgb without(QRgb pixel, int covered);
    QRgb around(int x, int y) const;
    std::optional<QRgb> beside(int x, int y, int right, int down) const;

    QImage& image_;
    const QImage& removed_;
    int far_;
};

/// A pixel without a line that covers `covered` of 255 of it. What shows through lines is the
/// product of what shows through each, in whatever order they lie above each other.
QRgb Removing::without(QRgb pixel, int covered)
{
    const int alpha = qAlpha(pixel);
    if (covered == 0)
        return pixel;
    if (alpha <= covered + rounding)
        return 0; // it was there alone
    const int left = std::clamp(255 - (255 - alpha) * 255 / (255 - covered), 0, alpha);
    const auto scaled = [&](int channel) { return (channel * left + alpha / 2) / alpha; };
    return qRgba(scaled(qRed(pixel)), scaled(qGreen(pixel)), scaled(qBlue(pixel)), left);
}

/// Searches in one direction for a pixel that is not removed completely, and returns what remains
/// of it. Beyond the image nothing remains. Empty: none is near.
std::optional<QRgb> Removing::beside(int x, int y, int right, int down) const
{
    const bool isDone = right < 0 || down < 0; // from the top, and from the left
    for (int i = 1; i <= far_; ++i) {
        const int u = x + i * right, v = y + i * down;
        if (!image_.valid(u, v))
            return 0;
        const int covered = qAlpha(reinterpret_cast<const QRgb*>(removed_.constScanLine(v))[u]);
        if (covered >= complete)
            continue;
        const QRgb pixel = reinterpret_cast<const QRgb*>(image_.constScanLine(v))[u];
        return isDone ? pixel : without(pixel, covered);
    }
    return {};
}

/// Guesses what remains of a pixel that is removed completely. A line that crosses it is seen on
/// two opposite sides. Where all pixels nearby are removed, too, the lines are so many that others
/// cover them: the pixel stays.
QRgb Removing::around(int x, int y) const
{
    std::optional<QRgb> most;
    for (const auto& [right, down] : {std::pair{1, 0}, {0, 1}}) {
        const auto one = beside(x, y, right, down), other = beside(x, y, -right, -down);
        if (!one || !other)
            continue;
        const QRgb less = qAlpha(*one) < qAlpha(*other) ? *one : *other;
        if (!most || qAlpha(less) > qAlpha(*most))
            most = less;
    }
    return most.value_or(reinterpret_cast<const QRgb*>(image_.constScanLine(y))[x]);
}

} // namespace

void paintAnew(QImage& image, const DifferingLayer& layer, Band band, const RasterOptions& options)
{
    double widest = 0;
    for (const DrawCommand& command : layer.removed.kept.commands)
        widest = std::max(widest, command.stroke->width * options.pixelRatio);
    Removing(image, rasterised(layer.removed, band, options), widest).remove();
    QPainter(&image).drawImage(0, 0, rasterised(layer.shown, band, options));
}

} // namespace app
