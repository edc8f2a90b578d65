// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/study.h"

namespace app {

/// Why, in plain sentences, one for each table of an explanation: what a line of the commonest
/// class costs, who does with the fewest operations, and who is wrong.
QStringList reasons(const Explanation& explanation);

} // namespace app
