// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

namespace ui {

class MainWindow;

// Pages to read. None of them keeps the window from being used.

/// The page of resources/algorithms/ on an algorithm, or what its row says where there is none.
void showAlgorithmPage(const clipping::Algorithm& algorithm, MainWindow& window);
/// Every command that has a key, by menu.
void showShortcuts(MainWindow& window);
void showAbout(MainWindow& window);

} // namespace ui
