// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

#include <cstddef>
#include <span>
#include <string_view>

namespace clipping {

/// Segments begin to end of an array, to be clipped into `out`, which holds end - begin pieces.
template <class T>
struct Batch {
    const BasicSegment<T>* segments;
    std::size_t begin, end;
    BasicWindow<T> window;
    BasicClipped<BasicSegment<T>>* out; ///< `source` counts from segments, not from begin
};

struct BatchResult {
    std::size_t pieces;    ///< written, in the order of the segments
    std::size_t unsettled; ///< segments that the vectors left to the scalar algorithm
};

/// `exact` for many segments in one set of instructions. All of them give the same bits.
struct InstructionSet {
    std::string_view name;
    bool available; ///< in this build and on this processor; otherwise do not call
    BatchResult (*clip)(const Batch<double>&);
    BatchResult (*clipSingle)(const Batch<float>&);
};

/// Every set there is, the slowest (and always available) first.
std::span<const InstructionSet> instructionSets();

/// `exact` for many segments in the fastest instructions that this processor has.
template <class T>
BatchResult clipBatch(const Batch<T>& batch);

} // namespace clipping
