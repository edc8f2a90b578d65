// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemView>

namespace ui {

/// Keeps one row of a list selected at all times: a click beside the rows, or with Ctrl on the
/// selected row, does not clear the selection. To be called after the view has its model.
void keepChoice(QAbstractItemView& view);

} // namespace ui
