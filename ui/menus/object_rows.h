// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/menus/actions.h"

#include <QString>

// Parts of the menu Object.

namespace ui {

std::vector<ActionInfo> groupRows();       ///< group, ungroup, enter, leave
std::vector<ActionInfo> orderRows();       ///< raise, lower, move to layer
std::vector<ActionInfo> turnRows();        ///< rotate by 90°, flip
std::vector<ActionInfo> arrangementRows(); ///< align, spread, make same size
std::vector<ActionInfo> pathRows();        ///< the steps that edit nodes
std::vector<ActionInfo> styleRows();       ///< style, eyedropper, copy and paste style

} // namespace ui

// Parts of the menu Edit.

namespace ui {

std::vector<ActionInfo> selectRows(); ///< layer, invert, same colour, find

class MainWindow;

/// Whether a command on the selection is enabled.
bool someSelected(const MainWindow& window);

/// Why a command on the selection is disabled.
QString nothingSelected();

} // namespace ui
