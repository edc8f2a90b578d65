// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style.h"

#include <QIcon>

#include <span>

namespace ui {

/// A selectable dash pattern; lengths in multiples of the stroke width.
struct DashPattern {
    QString name;
    std::vector<double> dashes; ///< empty: solid
};
std::span<const DashPattern> dashPatterns();

/// The pattern's dash lengths for a stroke of that width, in user units.
std::vector<double> scaled(const DashPattern& pattern, double width);
/// The index of a style's pattern; -1 if it is not in the catalogue.
int patternOf(const app::Style& style);

QIcon dashIcon(const DashPattern& pattern, const QColor& colour);

} // namespace ui
