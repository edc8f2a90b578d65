// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ui {

class MainWindow;

/// Gives the keyboard to the next pane of the canvas; after the last one to the bar across the top,
/// then to the column at the right, then to the canvas again. `by`: 1, or -1 for the way back.
void goToNextPart(MainWindow& window, int by);

} // namespace ui
