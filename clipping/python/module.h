// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/algorithm.h"
#include "clipping/convex_window.h"
#include "clipping/gradual_underflow.h"
#include "clipping/ieee_numbers.h"

#include <array>
#include <pybind11/pybind11.h>
#include <vector>

// The extension module _clearcut. The package clearcut (clipping/python/clearcut) checks what its
// users pass, and calls these functions with arrays of the right type and shape.

namespace clipping::python {

/// Every function that computes is defined with this guard: a Python process has the processor's
/// modes FTZ and DAZ if any extension in it is linked with -ffast-math.
using Guarded = pybind11::call_guard<GradualUnderflow>;

using WindowNumbers = std::array<double, 4>; ///< xmin, ymin, xmax, ymax

/// The polygon with these corners. Throws ValueError, with the reason, if it is none.
ConvexWindow polygonOf(const std::vector<std::array<double, 2>>& corners);

/// Clips at a polygon with a row of the catalogue that has this form. Edge i runs between the
/// corners i and i + 1 that were given, whatever the row. Returns the number of pieces.
std::size_t clipAllAt(const ConvexWindow& window, const Algorithm& row, std::span<const Segment> in,
                      std::span<Clipped> out);

void defineClip(pybind11::module_& module);
void definePolylines(pybind11::module_& module);
void defineChunks(pybind11::module_& module);
void defineCatalogue(pybind11::module_& module);

} // namespace clipping::python
