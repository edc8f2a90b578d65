// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/narration.h"

namespace app {

/// The variables that a step reads or writes, at most six: first those that it changes, then those
/// in its line of the pseudo-code, with coordinates of the line and the window. Empty if the trace
/// does not have the step.
std::vector<Variable> stepVariables(const TracedLine& tracedLine, const Narration& narration,
                                    std::size_t step);

/// The variables of the trace after a step and the coordinates that were given: those of the line
/// and of a rectangular window. Empty if the trace does not have the step.
std::vector<Variable> allVariables(const TracedLine& tracedLine, const Narration& narration,
                                   std::size_t step);

} // namespace app
