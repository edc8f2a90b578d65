// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>
#include <QPoint>

#include <memory>
#include <span>
#include <string_view>

namespace ui {

class MainWindow;

/// The menus of the right button on the canvas, its rulers, clip windows and the
/// list of algorithms (algorithm_menu.h). They hold actions of the menu bar: those that are
/// enabled. After addMenus' actions exist.
void addContextMenus(MainWindow& window);

/// A menu of those actions that are enabled now; an empty key is a separator. Deletes itself when
/// it is closed.
QMenu* contextMenu(MainWindow& window, std::span<const std::string_view> keys);

/// The menu of the clip window that tools act on: on its outline, its name or its row. Deletes
/// itself when it is closed.
QMenu* windowMenu(MainWindow& window);

} // namespace ui
