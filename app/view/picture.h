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

/// A polyline on screen, in logical pixels from the top left corner of the canvas.
struct Polyline {
    std::uint32_t first, count; ///< in DrawList::points; at least two
    bool closed;                ///< the last point equals the first: a join there, no caps
    bool capAtStart, capAtEnd;  ///< true for the stroke's own ends; ends made by a cut are butt
};

/// A stroke style; the width is in logical pixels.
struct StrokeStyle {
    Colour colour;
    double width = 1;
    Cap cap = Cap::Butt;
    Join join = Join::Miter;
    double miterLimit = 4;
    friend bool operator==(const StrokeStyle&, const StrokeStyle&) = default;
};

/// A draw command: consecutive polylines that are stroked with one style, or filled together as one
/// area.
struct DrawCommand {
    std::optional<StrokeStyle> stroke;
    Colour fill{};
    FillRule rule = FillRule::NonZero;
    std::uint32_t firstPolyline = 0, polylines = 0;
};

/// A draw list: draw commands from bottom to top.
struct DrawList {
    std::vector<DrawCommand> commands;
    std::vector<Polyline> polylines;
    std::vector<QPointF> points;

    std::span<const Polyline> polylinesOf(const DrawCommand& command) const
    {
        return std::span(polylines).subspan(command.firstPolyline, command.polylines);
    }
    std::span<const QPointF> pointsOf(const Polyline& polyline) const
    {
        return std::span(points).subspan(polyline.first, polyline.count);
    }
};

/// One frame as draw lists, painted in this order: the ghost, as a whole with the ghost's opacity
/// (so that overlapping ghosts do not add up); the kept part; the selected objects (`selected`);
/// the differing pieces.
struct Picture {
    DrawList ghost, kept, selected, differing;
};

/// How ghosts are mixed with the page colour if they are not a translucent layer.
struct Ghosting {
    Colour page;
    double opacity;
};

/// The options of a frame.
struct PictureOptions {
    View view;
    RemovedPart removed = RemovedPart::Ghosted;
    std::optional<Colour> page; ///< make all colours visible on this page colour; empty: leave them
                                ///< unchanged
    double leastWidth = 0.75;   ///< logical pixels; thinner strokes are drawn this wide
    double strokes = 1;         ///< factor of stroke widths
    /// For projectors: ghosts are drawn in opaque colours visible on this page (see ghostColour in
    /// visible_colour.h), instead of as a layer with the ghost's opacity.
    std::optional<Ghosting> ghosting{};
    std::span<const ObjectRange> selection{}; ///< objects to draw again, on top, in `light`
    Colour light{};
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
};

/// A frame as the canvases paint it. `lines` are the frame's lines, `styles` the styles of their
/// document. Everything is clipped to the view, so that painters get no huge numbers at deep zoom.
/// Dashed strokes are divided into dashes. Objects kept whole are filled, cut objects are outlines.
/// Strokes move by less than a quarter of a pixel where many points fall into one pixel.
Picture picture(const StyleTable& styles, const SceneLines& lines, const SceneFrame& frame,
                const PictureOptions& options);

} // namespace app
