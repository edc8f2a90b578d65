// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

#include <algorithm>

/// Whether a drawing was read with a loss that is not a remark.
inline bool isLossy(const app::Imported& imported)
{
    return std::ranges::any_of(imported.report, [](const app::Loss& loss) { return !loss.remark; });
}
