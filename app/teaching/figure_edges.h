// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/figure_frame.h"

#include <array>
#include <vector>

// Where the edges of a rectangular window are drawn. In a picture that magnifies its line they can
// be far outside. Such an edge is drawn at the picture's rim, and break marks show that the way
// there is shortened. Nothing else in a figure is schematic.

namespace app {

/// Where one edge is drawn.
struct EdgePlace {
    enum class At : std::uint8_t {
        Scale, ///< where it is
        Rim,   ///< outside the picture: near its border
        Away,  ///< outside the picture, where a place at its rim would be wrong: not at all
    };
    At at = At::Away;
    double place = -1e6;             ///< x or y of its infinite line in the picture
    double inward = 0;               ///< at the rim: the way to the picture's middle, 1 or −1
    std::optional<double> further{}; ///< at the rim: how far it is from the line, in the drawing
};

/// The edges of a traced line's window in a picture. Not for polygons.
class FigureEdges {
public:
    FigureEdges(const TracedLine& tracedLine, const FigureFrame& frame);

    const EdgePlace& operator[](clipping::Edge edge) const { return places_[std::size_t(edge)]; }
    bool areToScale() const; ///< all that are drawn; so is the window then

    /// The edge's infinite line in the picture; empty if it is away. It ends at edges at the rim
    /// unless it is to scale itself.
    std::optional<QLineF> line(clipping::Edge edge) const;
    /// The edge itself, the side of the window; empty if none of it is in the picture.
    std::optional<QLineF> side(clipping::Edge edge) const;
    /// The window in the picture; a line or a point if it has no size. It can reach out of the
    /// picture.
    QRectF window() const;
    /// The part of the picture beyond an edge; empty if there is none.
    QRectF beyond(clipping::Edge edge) const;

    /// A break mark: its middle, on the line of an edge.
    struct Break {
        QPointF place;
        bool acrossVertical; ///< the line that it breaks is vertical
    };
    std::vector<Break> breaks() const;
    QRectF boxOf(const Break& mark) const;
    double unit() const { return unit_; }

private:
    void placePair(const TracedLine& tracedLine, const FigureFrame& frame, glm::length_t axis);
    void addBreaks(std::vector<Break>& marks, clipping::Edge edge) const;
    double inset(glm::length_t axis, double most, double share) const;

    std::array<EdgePlace, 5> places_{};
    QRectF picture_;
    YAxis y_;
    double unit_;
};

} // namespace app
