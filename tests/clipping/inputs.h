// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <span>
#include <vector>

/// What the algorithms are tried on: families of segments with their windows, the same at every
/// run.
struct Input {
    clipping::Segment segment;
    clipping::Window window;
};

struct Family {
    const char* name;
    std::vector<Input> (*inputs)();
};

std::span<const Family> families();

/// Every segment between points of a small grid, with windows of area, without height, width or
/// both, and of the whole grid.
std::vector<Input> grid();

/// A million lines of the paper's scene.
std::vector<Input> scene();
