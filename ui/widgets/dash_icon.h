// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style.h"

#include <QIcon>

#include <span>

namespace ui {

/// A dash pattern to choose; lengths in widths of the stroke.
struct DashPattern {
    QString name;
    std::vector<double> dashes; ///< empty: solid
};
std::span<const DashPattern> dashPatterns();

/// The pattern for a stroke of that width, in user units.
std::vector<double> scaled(const DashPattern& pattern, double width);
/// The pattern that a style has; -1 if it is none of ours.
int patternOf(const app::Style& style);

QIcon dashIcon(const DashPattern& pattern, const QColor& ink);

} // namespace ui
