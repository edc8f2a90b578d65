// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "tests/benchmarks/clip/race.h"

/// What issue 3 asks of `exact` and of the scalar rows, each with what was measured: met, or not.
/// A target whose race was not run is left out.
void printTargets(std::span<const Race> races);

/// Each scalar row beside the fastest peer that implements the same algorithm, on the paper's
/// scene.
void printScalars(std::span<const Race> races);
