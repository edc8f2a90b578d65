// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ui {

class MainWindow;

// Pages to read. None of them keeps the window from being used.

/// Every command that has a key, by menu.
void showShortcuts(MainWindow& window);
void showAbout(MainWindow& window);

} // namespace ui
