// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ui {

class MainWindow;

// Selected objects that the pointer carries out of their drawing.

enum class Leaves : bool { No, Yes }; ///< whether they are gone there

/// Adds what is selected to another drawing, when that has been read.
void giveSelection(MainWindow& from, MainWindow& to, Leaves leaves);
/// To another program, as what *Copy* puts on the clipboard. Waits for the end of the drag.
void dragOut(MainWindow& from);

} // namespace ui
