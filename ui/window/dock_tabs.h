// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>

class QMainWindow;

namespace ui {

class Dock;

// The tabs of docks that share a place. Qt creates and deletes their tab bars together with the
// docks, and gives no access to them but as children of the window.

/// Gives each dock its title bar, or none if its tab is the title, and the tab bars our style.
void refreshTitles(QMainWindow& window, const QList<Dock*>& docks);

/// The height of the tab bar above a dock, in logical pixels; 0: none.
int heightOfTabs(const QMainWindow& window, const Dock& dock);

} // namespace ui
