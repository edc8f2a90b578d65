// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/study.h"

namespace app {

/// Explains the times in plain sentences, one for each table of an explanation: the cost of a line
/// of the most frequent class, the algorithm with the fewest operations, and the wrong results.
QStringList reasons(const Explanation& explanation);

} // namespace app
