// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

#include <QMenu>

namespace ui {

class MainWindow;

/// The menu of a row in the list of algorithms: only what applies to this algorithm now. Deletes
/// itself when it is closed.
QMenu* algorithmMenu(MainWindow& window, const clipping::Algorithm& algorithm);

} // namespace ui
