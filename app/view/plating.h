// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/picture.h"

namespace app {

/// All of them as whole pieces.
std::vector<clipping::Clipped> untouched(std::span<const clipping::Segment> segments);

/// Makes a plate, shape by shape, bottom to top.
class Plating {
public:
    Plating(const PictureOptions& options, std::size_t expectedPieces);

    /// What is left of a shape. `whole` are all its segments, the first of them number `number` of
    /// the scene; `pieces` are not empty and in order.
    void add(const Shape& shape, std::span<const clipping::Segment> whole, std::size_t number,
             std::span<const clipping::Clipped> pieces);
    Plate take() { return std::move(plate_); }

private:
    // The chain being made; its points are the last of plate_.points.
    struct Open {
        Point last;                    // in the drawing
        std::optional<QPointF> unsaid; // a point too close to the one before it
        double phase;                  // length of the path before the chain
        bool capAtStart;
    };

    // A piece, or what of it is in the view.
    struct Part {
        clipping::Segment segment;
        bool cutA, cutB; // these ends are not the stroke's own
    };

    void fill(std::span<const clipping::Segment> whole, const Style& style);
    void stroke(const Style& style, std::span<const clipping::Segment> whole, std::size_t number,
                std::span<const clipping::Clipped> pieces);
    void beginCoat(const Ink& ink);
    std::optional<Part> partSeen(const clipping::Clipped& piece,
                                 const clipping::Segment& source) const;
    void begin(const Part& part, double phase);
    void proceed(const Point& to);
    void finish(bool capAtEnd);
    void finishDashed(bool capAtEnd);
    void pushChain(const Chain& chain);
    bool liesOnAnother(const Chain& chain);
    Colour shown(const Colour& colour);
    QPointF onScreen(const Point& p) const;

    const PictureOptions& options_;
    Plate plate_;
    clipping::Window seen_{}; // the view, with room for half a stroke
    std::optional<Open> open_;
    std::uint32_t openAt_ = 0;    // its first point
    std::vector<double> pattern_; // of the shape's dashes, in pixels
    Colour lastAsked_;
    std::optional<Colour> lastShown_;
    std::vector<std::uint32_t> recent_; // chains, by a hash of their points
};

} // namespace app
