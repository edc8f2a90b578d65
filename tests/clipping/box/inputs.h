// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/clipping/inputs.h"

using BoxInput = BasicInput<3>;
using BoxFamily = BasicFamily<3>;

/// The test inputs in three dimensions, the same in every run.
std::span<const BoxFamily> boxFamilies();

/// Every segment between points of a small grid, with boxes of volume, without extent on one, two
/// or all axes, and of the whole grid.
std::vector<BoxInput> boxGrid();
