// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/menus/actions.h"

#include <QCoreApplication>

// Parts of the menu Edit.

namespace ui {

/// Translates the texts of the menu Edit.
struct EditMenu {
    Q_DECLARE_TR_FUNCTIONS(EditMenu)
};

std::vector<ActionInfo> selectRows(); ///< layer, invert, same colour, find

} // namespace ui
