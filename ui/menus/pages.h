// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ui {

class MainWindow;

// Pages to read. None of them is modal.

/// Shows every command that has a shortcut, grouped by menu.
void showShortcuts(MainWindow& window);
void showAbout(MainWindow& window);

} // namespace ui
