// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/cut.h"

#include <QString>

namespace app {

/// "12 objects whole, 3 cut, 40 left out. Opened: 2." Counts of 0 are left out.
QString cutText(const CutCounts& counts);

/// What the cut left unchanged, the end of `cutText`: " Left alone on locked layers: 3.", or empty.
QString leftAloneText(const CutCounts& counts);

} // namespace app
