// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/polyline.h"

namespace CLEARCUT_API clipping {

/// A polyline to be clipped: points in the caller's memory, which must outlive it.
template <class T>
struct BasicPolyline {
    std::span<const glm::vec<2, T>> points; ///< fewer than 2^32
    bool closed = false; ///< whether it continues from its last point to its first
};
using Polyline = BasicPolyline<double>;

/// The visible part of a polyline as runs without a gap, in the order of the polyline; polyline.h
/// says what a run is. The memory is the library's: the spans are valid as long as the object
/// lives.
template <class T>
class BasicVisibleRuns {
public:
    using Point = glm::vec<2, T>; ///< of a polyline

    /// Clips the polyline. One of 2^32 points or more ends the program, with a sentence.
    BasicVisibleRuns(const BasicPolyline<T>& polyline, const BasicWindow<T>& window);
    /// Takes the memory of another one, which is empty afterwards.
    BasicVisibleRuns(BasicVisibleRuns&& other) noexcept : runs_(other.runs_)
    {
        other.runs_ = nullptr;
    }
    BasicVisibleRuns(const BasicVisibleRuns&) = delete;
    BasicVisibleRuns& operator=(const BasicVisibleRuns&) = delete;
    ~BasicVisibleRuns();

    std::size_t size() const noexcept;                  ///< number of runs
    bool empty() const noexcept { return size() == 0; } ///< whether nothing is visible

    /// The points of run i, one at least.
    std::span<const Point> operator[](std::size_t i) const noexcept;

    /// Where run i comes from and at which edges it was cut.
    const VisibleRun& run(std::size_t i) const noexcept;

private:
    const BasicPolylineRuns<T>* runs_;
};
using VisibleRuns = BasicVisibleRuns<double>;

} // namespace clipping
