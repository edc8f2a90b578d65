// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "tests/benchmarks/clip/race.h"

/// What is asked of `exact`, each with what was measured in these races: met, or not.
void printTargets(std::span<const Race> races);

/// Each scalar row beside the fastest peer that implements the same algorithm, on the paper's
/// scene.
void printScalars(std::span<const Race> races);
