// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/progress.h"

#include <QString>

namespace app {

/// "12 s", "3 minutes", "2 hours": rounded up below two minutes, else to the nearest.
QString durationText(double seconds);

/// "42 %, 12 s left"; only the share while the remaining time is unknown.
QString progressText(const Progress& progress);

} // namespace app
