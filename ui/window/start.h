// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ui {

class MainWindow;
class PanelLayout;
class StartPanel;

/// Lets the panel Start begin work in its window, and shows there what the window has open. Start
/// is left when a drawing is loaded or changed.
void connectStart(StartPanel& start, PanelLayout& layout, MainWindow& window);

} // namespace ui
