// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style.h"

namespace app {

/// Multiplies the lengths of a stroke: its width and its dashes.
inline void scaleStroke(Style& style, double scale)
{
    style.width *= scale;
    style.dashOffset *= scale;
    for (double& dash : style.dashes)
        dash *= scale;
}

} // namespace app
