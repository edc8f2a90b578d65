// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemView>

namespace ui {

/// In a list that shows which one is in use, one always is: a click beside the rows, or with Ctrl
/// on the chosen one, does not take its highlight away. To be called when the view has its model.
void keepChoice(QAbstractItemView& view);

} // namespace ui
