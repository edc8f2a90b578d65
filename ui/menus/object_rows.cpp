// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/menus/object_rows.h"

#include "ui/look/text.h"
#include "ui/window/main_window.h"

namespace ui {

bool someSelected(const MainWindow& window) { return !window.session().selection().empty(); }

QString nothingSelected() { return Text::tr("Nothing is selected. Select an object first."); }

} // namespace ui
