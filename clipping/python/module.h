// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/algorithm.h"
#include "clipping/convex_window.h"
#include "clipping/gradual_underflow.h"
#include "clipping/ieee_numbers.h"

#include <glm/vec2.hpp>

#include <optional>
#include <pybind11/pybind11.h>
#include <span>
#include <vector>

// The extension module _clearcut. Its functions check what is passed (arguments.h); the package
// clearcut (clipping/python/clearcut) explains them and names their results.

namespace clipping::python {

/// Every function that computes is defined with this guard: a Python process has the processor's
/// modes FTZ and DAZ if any extension in it is linked with -ffast-math.
using Guarded = pybind11::call_guard<GradualUnderflow>;

/// Lets other Python threads run while this one clips so many segments or points that it pays.
class Released {
public:
    explicit Released(std::size_t size)
    {
        if (size >= 1000) // some microseconds
            released_.emplace();
    }

private:
    std::optional<pybind11::gil_scoped_release> released_;
};

/// The polygon with these corners. Throws ValueError, with the reason, if it is none.
ConvexWindow polygonOf(std::span<const glm::dvec2> corners);

/// Clips at a polygon with a row of the catalogue that has this form. Edge i runs between the
/// corners i and i + 1 that were given, whatever the row. Returns the number of pieces.
std::size_t clipAllAt(const ConvexWindow& window, const Algorithm& row, std::span<const Segment> in,
                      std::span<Clipped> out);

void defineArguments(pybind11::module_& module);
void defineClip(pybind11::module_& module);
void definePolylines(pybind11::module_& module);
void defineWkb(pybind11::module_& module);
void defineChunks(pybind11::module_& module);
void defineCatalogue(pybind11::module_& module);

} // namespace clipping::python
