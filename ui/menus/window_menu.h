// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>

namespace ui {

class MainWindow;

/// The menu of the clip window that tools act on: on its outline, its name or its row. Deletes
/// itself when it is closed.
QMenu* windowMenu(MainWindow& window);

} // namespace ui
