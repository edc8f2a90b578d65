// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/page.h"

namespace app {

/// The origin for coordinates in a unit: the top left corner of the paper, or for user units the
/// origin of the drawing. Panels, rulers and `clip -w` all use it.
inline Point originOf(const Page& page, Unit unit)
{
    return unit == Unit::User ? Point(0) : page.min;
}

} // namespace app
