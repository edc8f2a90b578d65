// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ui {

class MainWindow;

/// Adds the commands that have no entry in the menu bar: those of the settings. The palette finds
/// them, and they can be given keys.
void addSettingCommands(MainWindow& window);

} // namespace ui
