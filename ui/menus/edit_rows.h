// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/menus/actions.h"

// Parts of the menu Edit.

namespace ui {

std::vector<ActionInfo> selectRows(); ///< layer, invert, same colour, find

} // namespace ui
