// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_ranges.h"
#include "app/scene/scene_frame.h"
#include "app/scene/scene_lines.h"
#include "app/view/removed_part.h"
#include "app/view/view.h"

#include <QPointF>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace app {

/// A run of points on the screen, in logical pixels from the canvas' top left corner.
struct Chain {
    std::uint32_t first, count; ///< of Plate::points; at least two
    bool closed;                ///< the last point is the first: a join there, no caps
    bool capAtStart, capAtEnd;  ///< the stroke's own ends get its cap; those made by a cut are butt
};

/// How a stroke is painted; the width in logical pixels.
struct Ink {
    Colour colour;
    double width = 1;
    Cap cap = Cap::Butt;
    Join join = Join::Miter;
    double miterLimit = 4;
    friend bool operator==(const Ink&, const Ink&) = default;
};

/// Chains painted alike, one after the other: stroked with an ink, or filled together as one area.
struct Coat {
    std::optional<Ink> stroke;
    Colour fill{};
    FillRule rule = FillRule::NonZero;
    std::uint32_t firstChain = 0, chains = 0;
};

/// What is painted, bottom to top.
struct Plate {
    std::vector<Coat> coats;
    std::vector<Chain> chains;
    std::vector<QPointF> points;

    std::span<const Chain> chainsOf(const Coat& coat) const
    {
        return std::span(chains).subspan(coat.firstChain, coat.chains);
    }
    std::span<const QPointF> pointsOf(const Chain& chain) const
    {
        return std::span(points).subspan(chain.first, chain.count);
    }
};

/// One frame as simple things to paint: the ghost first, as a whole with the ghost's opacity (so
/// that overlapping ghosts do not add up), the kept part over it, over both what is selected, and
/// over all what differs.
struct Picture {
    Plate ghost, kept, lit, differing;
};

/// How ghosts are mixed with the page when they are not a layer.
struct Ghosting {
    Colour page;
    double opacity;
};

/// What a frame is made for.
struct PictureOptions {
    View view;
    RemovedPart removed = RemovedPart::Ghosted;
    std::optional<Colour> page; ///< make the inks visible on this page; nothing: as they are
    double leastWidth = 0.75;   ///< logical pixels; thinner strokes are drawn so wide
    double strokes = 1;         ///< how many times as wide as they are strokes are drawn
    /// For projectors: ghosts are opaque inks that can be told from this page (ink.h, ghostInk)
    /// instead of a layer that is painted with the ghost's opacity.
    std::optional<Ghosting> ghosting{};
    std::span<const ObjectRange> selection{}; ///< objects to draw once more, over all, in `light`
    Colour light{};
    std::span<const clipping::Clipped> differing{}; ///< pieces to draw over all, in `marked`
    Colour marked{};
    /// A tick across what differs: where it is too short to be seen, or everywhere; none where that
    /// would hide the others.
    enum class Ticks : std::uint8_t { WhereShort, Everywhere };
    Ticks ticks = Ticks::WhereShort;
    /// Pieces to draw over all but what differs, each group in a colour that is seen on the page.
    struct Graded {
        std::span<const clipping::Clipped> pieces;
        Colour colour;
    };
    std::vector<Graded> graded{};
};

/// A frame as the canvases paint it. `lines` are those that it was made of, `styles` those of their
/// document. Everything is clipped to the view, so that deep zoom never hands them huge numbers;
/// dashes are cut up; objects of which all is kept are filled, cut ones are outlines. Strokes move
/// by less than a quarter of a pixel where many points fall into one.
Picture picture(const StyleTable& styles, const SceneLines& lines, const SceneFrame& frame,
                const PictureOptions& options);

} // namespace app
