// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_ranges.h"
#include "app/document/style_table.h"
#include "app/document/underlay.h"
#include "app/scene/region.h"
#include "app/view/view.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace app {

/// How the part removed by the clip windows is shown.
enum class RemovedPart : std::uint8_t { Ghosted, Hidden, Shown };

/// How ghosts are mixed with the page colour if they are not a translucent layer.
struct Ghosting {
    Colour page;
    double opacity;
};

/// How the border of a clip window is painted: a line with a wider one below it; widths and dashes
/// in logical pixels.
struct BorderLine {
    std::size_t step = 0; ///< of the region
    Colour colour{}, below{255, 255, 255};
    double width = 1, widthBelow = 0; ///< 0: there is no line below
    std::vector<double> dashes{};
    friend bool operator==(const BorderLine&, const BorderLine&) = default;
};

/// The options of a frame.
struct PictureOptions {
    View view;
    RemovedPart removed = RemovedPart::Ghosted;
    /// The clip windows at which areas are cut, as long as the options live. Null: areas are filled
    /// if all their lines are painted.
    const ClipRegion* region = nullptr;
    bool closesAreas = false;   ///< the stroke of a cut area runs along the cut, too
    double leastLength = 0;     ///< shorter pieces of cut lines are not kept (user units)
    std::optional<Colour> page; ///< make all colours visible on this page colour; empty: leave them
                                ///< unchanged
    double leastWidth = 0.75;   ///< logical pixels; thinner strokes are drawn this wide
    double strokes = 1;         ///< factor of stroke widths
    /// For projectors: ghosts are drawn in opaque colours visible on this page (see ghostColour in
    /// visible_colour.h), instead of as a layer with the ghost's opacity.
    std::optional<Ghosting> ghosting{};
    std::span<const SeenUnderlay> underlays{}; ///< the images below layers, from bottom to top
    /// Selected objects lie on a band of the colour `paper` with an outline in `light`.
    std::span<const ObjectRange> selection{};
    Colour light{}, paper{255, 255, 255};
    std::span<const clipping::Clipped> differing{}; ///< pieces to draw on top of everything, in
                                                    ///< `marked`
    Colour marked{};
    /// A tick across a differing piece: only if the piece is too short to be seen, or always; none
    /// where ticks would hide other pieces.
    enum class Ticks : std::uint8_t { WhereShort, Everywhere };
    Ticks ticks = Ticks::WhereShort;
    /// Pieces to draw above everything except the differing pieces, each group in a colour that is
    /// visible on the page.
    struct Graded {
        std::span<const clipping::Clipped> pieces;
        Colour colour;
    };
    std::vector<Graded> graded{};
    std::vector<BorderLine> borders{}; ///< to draw on top of everything
    std::stop_token stop{}; ///< when it is requested, the rest of the picture is left out
};

/// The width in which the strokes of a style are drawn, in logical pixels.
inline double strokeWidth(const Style& style, const PictureOptions& options)
{
    return std::max(style.width * options.view.zoom, options.leastWidth) * options.strokes;
}

} // namespace app
