// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/variants.h"

#include <QStyleOption>

class QPainter;

namespace ui {

/// Paints a variant's name at the left of a table cell: the marker, filled or hollow, the
/// abbreviation, and a muted "as published", shortened if it does not fit. A known misprint is
/// shown by its name.
void paintVariantName(QPainter& painter, const QRect& cell, const QStyleOptionViewItem& option,
                      const app::Variant& variant);

} // namespace ui
