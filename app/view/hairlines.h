// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/hairline.h"
#include "app/view/raster.h"

#include <memory>
#include <vector>

namespace app {

/// Many lines of one opaque colour that are at most a pixel wide. QPainter takes some 10 µs for one
/// as long as the page, whatever lies there already. Here their coverage adds up in tiles, as if
/// they were painted one over the other, in any order; a tile that is full lets further lines pass.
class Hairlines {
public:
    /// The band of an image that is `width` device pixels wide.
    Hairlines(int width, Band band);

    void add(const Hairline& line);

    /// Paints what was added on the band, and begins again.
    void paintOn(QImage& band, const Colour& colour);

private:
    struct Tile {
        std::uint8_t visits = 0; ///< since it was last searched for a gap
        bool begun = false, full = false;
    };

    template <bool steep>
    void walk(const Hairline& line);
    template <bool steep>
    void walkTile(const Hairline& line, int along, int across);
    std::uint16_t* shownIn(int tile);
    void visited(int tile);

    int width_, columns_;
    Band band_;
    std::vector<Tile> tiles_;
    std::unique_ptr<std::uint16_t[]> shown_; ///< of what is below, for each pixel of the tiles
    std::vector<int> begun_;                 ///< tiles with ink
};

} // namespace app
