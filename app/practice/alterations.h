// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/practice/kinds/kinds.h"

namespace app {

/// What a variable would be after a typical slip in its formula.
struct Alteration {
    std::string_view kind;
    double value;
    QString hint;
};

/// The typical slips of the planned variable's formula, evaluated with the values of the step.
/// Empty if the formula does not give the value of the trace with the variables as they are shown:
/// so where the code has turned the plane.
std::optional<std::vector<Alteration>> alterationsOf(const MoveContext& context);

} // namespace app
