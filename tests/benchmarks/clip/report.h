// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "tests/benchmarks/clip/race.h"

// Markdown, made of races. All of one table have the same numbers and count.

/// A row for every contender, a column for every scene: ns a segment, and in brackets the speed of
/// plain reading that this is.
void printTimes(std::span<const Race> races);

/// What of each scene is visible, and what the vectors left to the scalar algorithm.
void printFallbacks(std::span<const Race> races);

/// A row for every peer, a column for every scene: how its results differ from those of `exact`.
void printAgreements(std::span<const Race> races);
