// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>

class QAbstractItemModel;

namespace ui {

/// Copies cells as tab-separated text below the headings of their columns. `area`: columns are x,
/// rows are y.
void copyCells(const QAbstractItemModel& model, const QRect& area);

} // namespace ui
