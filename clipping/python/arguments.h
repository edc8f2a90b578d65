// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/python/module.h"

#include <glm/vec2.hpp>

#include <pybind11/numpy.h>

// What was passed, in the library's form and without copying coordinates. Each function throws a
// TypeError or ValueError that says what it got instead.

namespace clipping::python {

/// An array of shape (n, 4), float64 or float32, of any strides.
pybind11::array segmentsOf(pybind11::handle value);

bool isFloat32(const pybind11::array& segments);

/// The same, float64 only; `what` is named where it is not.
pybind11::array doublesOf(pybind11::handle value, const char* what);

/// (xmin, ymin, xmax, ymax), finite and not inverted.
Window windowOf(pybind11::handle value);

/// (x1, y1, x2, y2), finite.
Segment segmentOf(pybind11::handle value);

/// Three or more points (x, y).
std::vector<glm::dvec2> cornersOf(pybind11::handle value);

/// The points of a polyline where they are, whatever the strides are.
struct Points {
    pybind11::array array;              ///< keeps them
    std::ptrdiff_t row = 0, column = 0; ///< bytes from x to the next point's x, and to y
    bool areComplex = false;

    std::size_t size() const { return static_cast<std::size_t>(array.shape(0)); }
    /// Whether they are a plain array of dvec2.
    bool arePacked() const;
    /// These points, or copies of them in `copies`.
    std::span<const glm::dvec2> in(std::vector<glm::dvec2>& copies) const;
};

/// An array of shape (k, 2), float64, or a complex one of shape (k,). `what` names it.
Points pointsOf(pybind11::handle value, const std::string& what);

/// One or more whole numbers of 4 or 8 bytes, of any strides.
pybind11::array offsetsOf(pybind11::handle value);

/// The arrays of a list, or of anything that gives one after the other.
pybind11::list linesOf(pybind11::handle value);

/// The index of the value among the texts.
std::size_t choiceOf(pybind11::handle value, const char* name,
                     std::initializer_list<const char*> choices);

/// The row of the catalogue with that key or abbreviation.
const Algorithm& algorithmOf(pybind11::handle value);

/// The number of threads, 1 to 1024; 0, for all, if it is None.
int threadsOf(pybind11::handle value);

/// str(value).
std::string textOf(pybind11::handle value);

/// “an array of shape (3, 2) and dtype int64”, “a list”.
std::string whatIs(pybind11::handle value);

} // namespace clipping::python
