// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeyCombination>
#include <QList>

#include <optional>

class QAction;
class QKeyEvent;
class QMainWindow;
class QMenu;

namespace ui {

/// The key at the same place on an American keyboard, for keys that type no Latin letter or digit,
/// such as the digits of a French keyboard and all letters of a Greek one. Without it shortcuts
/// with letters or digits could not be typed there. Empty: the key types a Latin letter or digit,
/// or its place is unknown (only Linux's scan codes are known).
std::optional<QKeyCombination> keyAtItsPlace(const QKeyEvent& event);

/// Every command of a window: those in the menus, submenus included, in menu order, and the further
/// ones.
QList<QAction*> commands(QMainWindow& window);

/// The commands of a window without an entry in the menu bar, as submenus of a menu that is never
/// shown.
QMenu& furtherCommands(QMainWindow& window);

} // namespace ui
