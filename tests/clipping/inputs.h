// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <span>
#include <vector>

/// The test inputs: families of segments with their windows, the same in every
/// run.
template <glm::length_t N>
struct BasicInput {
    clipping::BasicSegment<double, N> segment;
    clipping::BasicWindow<double, N> window;
};
template <glm::length_t N>
struct BasicFamily {
    const char* name;
    const std::vector<BasicInput<N>>& (*inputs)(); ///< made by the first call
};
template <auto make>
const auto& madeOnce()
{
    static const auto all = make();
    return all;
}
using Input = BasicInput<2>;
using Family = BasicFamily<2>;

std::span<const Family> families();

/// The same kinds of input in numbers that are all floats.
std::span<const Family> singleFamilies();

/// Every segment between points of a small grid, with windows of area, without height, width or
/// both, and of the whole grid.
std::vector<Input> grid();

/// A million lines of the paper's scene.
std::vector<Input> scene();
