// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/batch/sets.h"

namespace clipping {

/// Polygons with more corners are only tested for rejection in vectors; what survives is searched
/// one by one.
constexpr std::size_t mostVectorCorners = 128;

/// What the vector kernel reads of a polygon with area: arrays of `size` numbers, with room for
/// eight at least.
struct PolygonTable {
    std::size_t size;
    /// For each edge: its first corner, and its extent as exact pairs.
    const double *cornerX, *cornerY, *edgeX, *edgeXLow, *edgeY, *edgeYLow;
    const double* index; ///< for each edge its index, as bits
    /// For each edge as bits: its number, shifted for the end a and for the end b of
    /// BasicClipped::cut in the upper half.
    const double *numberForA, *numberForB;
    const double*
        reach; ///< for each edge: 2 M (|ex| + |ey|), M the largest |coordinate| of a corner
    const double *offX, *offY; ///< each corner relative to the centre of the box, rounded
    Box<double> box;           ///< the bounding box
    double ux, uy, vx, vy;     ///< half sides of a parallelogram around that centre, enclosing it
    double acrossX, acrossY;   ///< at least |ux| + |vx| + |centreX| of the box, and the same in y
    bool hasAxisAligned;       ///< whether an edge is horizontal or vertical
    bool namesEveryCut;        ///< that of the PreparedPolygon
};

} // namespace clipping
