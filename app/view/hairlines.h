// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/hairline.h"
#include "app/view/raster.h"

#include <memory>
#include <vector>

namespace app {

/// A pixel below lines of one colour, which may come in any order: how much of what lies there is
/// still seen, 65,535 for all of it.
struct ShownPixel {
    std::uint16_t shown;

    void cover(unsigned share, const Colour&) { hide(share); }
    QRgb above(QRgb below, const Colour& colour) const
    {
        const unsigned covered = 255 - (shown * 255U + 32'767) / 65'535;
        return covered ? mixed(qRgb(colour.red, colour.green, colour.blue), below, covered) : below;
    }

protected:
    /// `share` of 256 of what shows is covered. Rounded down: lines above each other cover a pixel
    /// in the end.
    void hide(unsigned share) { shown = std::uint16_t(shown * (256 - share) >> 8); }
};

/// A pixel below lines of many colours, which come from the front to the back: also the colour that
/// is seen of them, 65,535 for the lightest.
struct InkedPixel : ShownPixel {
    std::uint16_t red, green, blue;

    void cover(unsigned share, const Colour& colour)
    {
        const unsigned before = shown;
        hide(share);
        const auto lit = [seen = before - shown](std::uint16_t ink, unsigned channel) {
            return std::uint16_t(std::min(ink + (seen * channel + 127) / 255, 65'535U));
        };
        red = lit(red, colour.red);
        green = lit(green, colour.green);
        blue = lit(blue, colour.blue);
    }
    QRgb above(QRgb below, const Colour&) const
    {
        if (shown == 65'535)
            return below;
        const auto channel = [&](int ink, int under) {
            return (ink * 255 + under * shown + 32'767) / 65'535;
        };
        return qRgba(channel(red, qRed(below)), channel(green, qGreen(below)),
                     channel(blue, qBlue(below)), channel(65'535 - shown, qAlpha(below)));
    }
};

/// Many opaque lines that are at most a pixel wide. QPainter takes some 10 µs for one as long as
/// the page, whatever lies there already. Here their coverage adds up in tiles, as if they were
/// painted one over the other; a tile that is full lets further lines pass.
template <class Pixel>
class HairlineTiles {
public:
    /// The band of an image that is `width` device pixels wide.
    HairlineTiles(int width, Band band);

    void add(const Hairline& line, const Colour& colour);

    /// Paints what was added on the band, and begins again.
    void paintOn(QImage& band);

private:
    struct Tile {
        std::uint8_t visits = 0; ///< since it was last searched for a gap
        bool begun = false, full = false;
    };

    struct TileRange {
        int left, right, top, bottom; ///< the first and the last ones
    };
    bool areFull(const TileRange& tiles) const;
    template <bool steep>
    void walk(const Hairline& line);
    template <bool steep>
    void walkTile(const Hairline& line, int along, int across);
    Pixel* pixelsIn(int tile);
    void visited(int tile);

    int width_, columns_;
    Band band_;
    Colour colour_{}; ///< of the last line
    std::vector<Tile> tiles_;
    std::vector<std::uint64_t> full_; ///< a row of tiles, of which the first 64 have bits
    std::unique_ptr<Pixel[]> pixels_; ///< of the tiles
    std::vector<int> begun_;          ///< tiles with ink
};

using Hairlines = HairlineTiles<ShownPixel>;         ///< of one colour until paintOn()
using ColouredHairlines = HairlineTiles<InkedPixel>; ///< from the front to the back

extern template class HairlineTiles<ShownPixel>;
extern template class HairlineTiles<InkedPixel>;

} // namespace app
