// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/variants.h"

#include <QStyleOption>

class QPainter;

namespace ui {

/// Paints who clips into a cell of a table, from its left: the marker, filled or hollow, the
/// abbreviation, and in muted text "as published", shorter where there is no room; an exhibit by
/// its name.
void paintVariantName(QPainter& painter, const QRect& cell, const QStyleOptionViewItem& option,
                      const app::Variant& variant);

} // namespace ui
