// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/outline.h"
#include "app/view/picture_options.h"
#include "app/view/polyline_builder.h"

namespace app {

/// One whole piece for each segment.
std::vector<clipping::Clipped> untouched(std::span<const clipping::Segment> segments);

/// Builds a draw list object by object, from bottom to top.
class DrawListBuilder {
public:
    DrawListBuilder(const PictureOptions& options, std::size_t expectedPieces);
    DrawListBuilder(const DrawListBuilder&) = delete;
    DrawListBuilder& operator=(const DrawListBuilder&) = delete;

    /// Adds the remaining part of an object. `whole` are all its lines; the first is number
    /// `number` of the scene. `pieces` must be in order and not empty.
    void add(const Style& style, std::span<const clipping::Segment> whole, std::size_t number,
             std::span<const clipping::Clipped> pieces);

    // The same in steps, for lines that are not contiguous in memory.

    /// Sets the style for the following calls; the style must outlive them.
    void setStyle(const Style& style);
    /// Fills an object that is kept whole. Its style must have a fill.
    void fill(const Outline& whole);
    /// Begins the strokes of an object. An area without a stroke style is drawn as its outline.
    void beginStrokes();
    /// Ends the strokes of the current object.
    void endObject() { polylines_.end(); }
    /// Adds an image above what was added. Strokes must be begun again.
    void add(const SharedUnderlay& image);
    /// `before`: the length of the outline before the line, used only for dashed styles.
    void stroke(const clipping::Clipped& piece, const clipping::Segment& line, double before = 0);
    /// Strokes a whole line that must lie inside `seen()`.
    void strokeSeen(const clipping::Segment& line, double before = 0);

    bool isDashed() const { return polylines_.isDashed(); }
    /// The view, enlarged by half a stroke width. Strokes outside it are skipped.
    const clipping::Window& seen() const { return seen_; }
    /// The view, slightly enlarged. Areas outside it are skipped.
    const clipping::Window& filled() const { return filled_; }

    DrawList take();

private:
    std::optional<SeenPart> partSeen(const clipping::Clipped& piece,
                                     const clipping::Segment& source) const;
    Colour shown(const Colour& colour);

    const PictureOptions& options_;
    DrawList drawList_;
    PolylineBuilder polylines_{drawList_, options_.view};
    clipping::Window filled_, seen_{};
    const Style* style_ = nullptr;
    StrokeStyle strokeStyle_;
    Colour lastAsked_;
    std::optional<Colour> lastShown_;
};

} // namespace app
