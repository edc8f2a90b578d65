// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/area/both_sides.h"
#include "clipping/area/boundary.h"

namespace clipping {

/// Finds the boundary of the points that two regions keep.
///
/// It walks along each edge, past all edges that meet it in their exact order, and keeps the
/// winding numbers on both sides. A part of the edge with the result on one side only is a piece of
/// the boundary. Edges that coincide have the same sides: only the first of them gives a piece.
class BoundarySweep {
public:
    BoundarySweep(const PreparedRegion::Data& area, const PreparedRegion::Data& window);

    void walkAreaEdge(const AreaEdge& edge);
    void walkWindowEdge(const AreaEdge& edge);

    /// All pieces so far, without those that rounding made a point.
    std::span<const BoundaryPiece> pieces() const { return pieces_; }
    bool isEmpty() const { return isEmpty_; } ///< whether there was no piece
    /// Whether they are the boundary of the area: the window has removed no part of an edge and
    /// added none.
    bool isWhole() const { return isWhole_; }

private:
    struct Input {
        const PreparedRegion::Data& region;
        BothSides sides;
        bool isWindow;

        bool isApartFrom(const Segment& s) const;
    };
    /// A place on the edge where something changes.
    struct Stop {
        Meeting meeting;
        Input* input; ///< to which the meeting's edge belongs
        int covers;   ///< 0, or for an edge along this one that comes before it: 1 where it begins,
                      ///< -1 where it ends, and nothing else changes
    };
    /// An end of a piece.
    struct Place {
        glm::dvec2 at;
        double share;
    };

    void walk(const AreaEdge& edge, Input& own, Input& other);
    void findStops(const SweptLine& swept, const AreaEdge& edge, Input& own, Input& input);
    void sortStops(const SweptLine& swept);
    int coversFrom(const SweptLine& swept);
    void passStops(const SweptLine& swept, const AreaEdge& edge, const Input& own);
    bool isBoundary(const Input& own);
    void append(const AreaEdge& edge, const Input& own, const Place& from, const Place& to);

    Input area_, window_;
    std::vector<Stop> stops_;
    std::vector<const AreaEdge*> along_; ///< edges along this one that come before it
    std::vector<BoundaryPiece> pieces_;
    bool isEmpty_ = true, isWhole_ = true;
};

} // namespace clipping
