// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/menus/needs.h"

#include "ui/window/main_window.h"

#include <QCoreApplication>

namespace ui {

bool someSelected(const MainWindow& window) { return !window.session().selection().empty(); }

QString nothingSelected()
{
    return QCoreApplication::translate("Menus", "Nothing is selected. Select an object first.");
}

} // namespace ui
