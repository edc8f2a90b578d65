// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/menus/needs.h"

#include <QCoreApplication>

namespace ui {

QString nothingSelected()
{
    return QCoreApplication::translate("Menus", "Nothing is selected. Select an object first.");
}

} // namespace ui
