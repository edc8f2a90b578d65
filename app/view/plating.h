// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/chaining.h"
#include "app/view/outline.h"

namespace app {

/// All of them as whole pieces.
std::vector<clipping::Clipped> untouched(std::span<const clipping::Segment> segments);

/// Makes a plate, object by object, bottom to top.
class Plating {
public:
    Plating(const PictureOptions& options, std::size_t expectedPieces);
    Plating(const Plating&) = delete;
    Plating& operator=(const Plating&) = delete;

    /// What is left of an object. `whole` are all its lines, the first of them number `number` of
    /// the scene; `pieces` are not empty and in order.
    void add(const Style& style, std::span<const clipping::Segment> whole, std::size_t number,
             std::span<const clipping::Clipped> pieces);

    // The same in steps, so that the lines need not be in a row.

    /// How what follows is painted; the style must stay where it is.
    void setStyle(const Style& style);
    /// Fills an object of which all is left. Its style has a fill.
    void fill(const Outline& whole);
    /// Strokes follow. Those of an area without a stroke are its outline.
    void beginStrokes();
    /// Strokes of another object follow.
    void endObject() { chains_.end(); }
    /// `before`: the length of the outline before the line. Of use only where the style is dashed.
    void stroke(const clipping::Clipped& piece, const clipping::Segment& line, double before = 0);
    /// A line that lies in `seen()`, and of which all is left.
    void strokeSeen(const clipping::Segment& line, double before = 0);

    bool isDashed() const { return chains_.isDashed(); }
    /// The view, with room for half a stroke. Only what meets it is stroked.
    const clipping::Window& seen() const { return seen_; }
    /// The view, with some room. Only what meets it is filled.
    const clipping::Window& filled() const { return filled_; }

    Plate take();

private:
    std::optional<SeenPart> partSeen(const clipping::Clipped& piece,
                                     const clipping::Segment& source) const;
    Colour shown(const Colour& colour);

    const PictureOptions& options_;
    Plate plate_;
    Chaining chains_{plate_, options_.view};
    clipping::Window filled_, seen_{};
    const Style* style_ = nullptr;
    Ink ink_;
    Colour lastAsked_;
    std::optional<Colour> lastShown_;
};

} // namespace app
