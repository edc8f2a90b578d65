// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/page.h"

namespace app {

/// The point from which places are counted in a unit: the paper's top left corner, or the drawing's
/// own origin in user units. Panels, rulers and `clip -w` follow this one rule.
inline Point originOf(const Page& page, Unit unit)
{
    return unit == Unit::User ? Point(0) : page.min;
}

} // namespace app
