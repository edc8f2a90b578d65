// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>

class QAction;
class QMenuBar;

namespace ui {

/// Every command in the menus, submenus included, in menu order.
QList<QAction*> commands(const QMenuBar& menus);

} // namespace ui
