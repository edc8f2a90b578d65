// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/menus/actions.h"

// Parts of the menu Object.

namespace ui {

std::vector<ActionInfo> groupRows();       ///< group, ungroup, enter, leave
std::vector<ActionInfo> orderRows();       ///< raise, lower, move to layer
std::vector<ActionInfo> turnRows();        ///< rotate by 90°, flip
std::vector<ActionInfo> arrangementRows(); ///< align, spread, make same size
std::vector<ActionInfo> pathRows();        ///< the steps that edit nodes
std::vector<ActionInfo> styleRows();       ///< style, eyedropper, copy and paste style

} // namespace ui
