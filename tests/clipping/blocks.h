// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/clipping/answers.h"

/// Blocks of every kind of input that is hard, for questions of that kind: the paper's scene, small
/// grids, contacts within a few ulps, any finite number, denormals, ±0, windows without extent,
/// infinities and NaN. `count` random segments a block; a grid has all of its segments, whatever
/// `count`. Made by integer arithmetic, so that they are the same bits on every machine.
std::vector<Block> hardBlocks(Numbers numbers, std::size_t count);
