// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

#include <cstddef>
#include <span>
#include <string_view>

namespace clipping {

/// The segments from `begin` to `end` of an array, to be clipped into `out`, which has room for end
/// - begin pieces.
template <class T>
struct Batch {
    const BasicSegment<T>* segments;
    std::size_t begin, end;
    BasicWindow<T> window;
    BasicClipped<BasicSegment<T>>* out; ///< `source` is relative to `segments`, not to `begin`
};

struct PreparedPolygon;
struct PolygonTable;

/// The same for a convex polygon with area.
struct PolygonBatch {
    const Segment* segments;
    std::size_t begin, end;
    const PreparedPolygon* polygon;
    const PolygonTable* table; ///< of this polygon
    BasicClipped<Segment>* out;
};

struct BatchResult {
    std::size_t pieces;    ///< number written, in the order of the segments
    std::size_t unsettled; ///< number of segments that were left to the scalar algorithm
};

/// `exact` for many segments with one instruction set. All sets give the same result, bit for bit.
struct InstructionSet {
    std::string_view name;
    bool available; ///< in this build and on this processor; if false, do not call the functions
    BatchResult (*clip)(const Batch<double>&);
    BatchResult (*clipSingle)(const Batch<float>&);
    BatchResult (*clipPolygon)(const PolygonBatch&);
};

/// All instruction sets; the first is the slowest and always available.
std::span<const InstructionSet> instructionSets();

/// `exact` for many segments with the fastest instruction set of this processor.
/// Not hidden in a shared library, because clipping_parallel calls it.
template <class T>
CLEARCUT_API BatchResult clipBatch(const Batch<T>& batch);
BatchResult clipBatch(const PolygonBatch& batch);

} // namespace clipping
