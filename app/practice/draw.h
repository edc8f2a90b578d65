// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/practice/move.h"

#include <cstdint>

namespace app {

/// The line of an attempt: drawn by its seed from families of lines (lessons/families.h), at which
/// the variant ends, and whose moves cannot be passed by chance. Equal seeds give equal lines. y
/// points up. Takes at most about a millisecond.
TracedLine practiceLine(const Variant& variant, std::uint64_t seed);

/// How many first tries must be right to pass: at least two thirds, and so many that random answers
/// pass with a probability of at most 0.65 %; more than there are moves if even all do not suffice.
int neededFirstTries(const std::vector<Move>& moves);

} // namespace app
