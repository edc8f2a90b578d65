// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/area/both_sides.h"
#include "clipping/area/boundary.h"
#include "clipping/area/edge_stops.h"

namespace clipping {

/// Finds the boundary of the points that two regions keep.
///
/// It walks along each edge, past all edges that meet it in their exact order, and keeps the
/// winding numbers on both sides. A part of the edge with the result on one side only is a piece of
/// the boundary. Edges that coincide have the same sides: only the first of them gives a piece, of
/// the area's edges and then the window's.
class BoundarySweep {
public:
    BoundarySweep(const PreparedRegion::Data& area, const PreparedRegion::Data& window);

    void walkAreaEdge(const AreaEdge& edge) { walk(edge, area_, window_); }
    void walkWindowEdge(const AreaEdge& edge) { walk(edge, window_, area_); }

    /// All pieces so far, without those that rounding made a point.
    std::span<const BoundaryPiece> pieces() const { return pieces_; }
    bool isEmpty() const { return isEmpty_; } ///< whether there was no piece
    /// Whether they are the boundary of the area: the window has removed no part of an edge and
    /// added none.
    bool isWhole() const { return isWhole_; }

private:
    struct Input {
        const PreparedRegion::Data& region;
        EdgesNear near;
        BothSides sides;
        bool isWindow;
        const AreaEdge* entered = nullptr; ///< the edge at whose start the sides are

        bool isApartFrom(const Segment& s) const;
        void enter(const SweptLine& swept, const AreaEdge& edge);
    };

    void walk(const AreaEdge& edge, Input& own, Input& other);
    bool findStops(const SweptLine& swept, const AreaEdge& edge, bool isOwn, Input& input);
    void passStops(const SweptLine& swept, const AreaEdge& edge, bool isOfWindow);
    std::size_t pass(const SweptLine& swept, std::size_t first, int& covers);
    glm::dvec2 placeOf(const SweptLine& swept, std::size_t stop) const
    {
        return pointOf(swept, stops_[stop].meeting);
    }
    bool isBoundary(bool isOfWindow);
    void append(const AreaEdge& edge, bool isOfWindow, const glm::dvec2& from,
                const glm::dvec2& to);

    Input area_, window_;
    EdgeStops stops_;
    std::vector<BoundaryPiece> pieces_;
    bool isEmpty_ = true, isWhole_ = true;
};

} // namespace clipping
