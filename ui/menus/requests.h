// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ui {

class MainWindow;

/// Carries out what the parts of a window ask for and rooms above it hold: pages about algorithms,
/// the experiment, the export of steps, and the commands in the option bar. The window has its
/// menus already.
void connectRequests(MainWindow& window);

} // namespace ui
