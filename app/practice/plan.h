// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/practice/move.h"

#include <span>

namespace app {

/// Where the pseudo-code of a form asks the student: before each step with this label.
struct PlannedMove {
    std::string_view label;
    MoveKind kind;
    /// Bits, Value: the variable. Edge: the variable that numbers an edge; empty: the next cut.
    std::string_view variable{};
    /// Decide: labels, separated by spaces, of further tests that belong to the decision.
    std::string_view also{};
    int most = 100; ///< times in an attempt: what was understood is not asked for ever
};

/// The plan of a variant; empty if it has none.
std::span<const PlannedMove> planOf(const Variant& variant);
/// The variants with a plan: both forms of the algorithms of the paper, in the order of the menu.
std::vector<Variant> practiceVariants();

} // namespace app
