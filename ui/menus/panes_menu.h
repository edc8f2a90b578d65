// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/menus/actions.h"

namespace ui {

/// The rows of the submenu Panes in the menu Compare.
std::vector<ActionInfo> panesRows();

} // namespace ui
