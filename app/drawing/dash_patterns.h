// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/expression.h"
#include "app/document/style_table.h"

#include <QLocale>
#include <QString>

#include <span>

namespace app {

/// A usual dash pattern; lengths in multiples of the stroke width.
struct DashPattern {
    QString name;
    std::vector<double> dashes; ///< empty: solid
};
/// The catalogue, in menu order. The first one is solid.
std::span<const DashPattern> dashPatterns();

/// The pattern's dash lengths for a stroke of that width, in user units.
std::vector<double> scaled(const DashPattern& pattern, double width);
/// The index of a style's pattern; empty if it is not in the catalogue.
std::optional<std::size_t> patternOf(const Style& style);

/// Sets the stroke width in user units. A usual pattern grows with it; other dashes stay.
void setWidth(Style& style, double width);

/// Dash lengths as people type them: lengths with or without units, separated by spaces or ";",
/// also by "," if that is not the decimal point: "2 1", "3mm 1mm 0.5mm 1mm". In user units. No text
/// means solid. The error is a whole sentence.
Result<std::vector<double>> typedDashes(const QString& text, const Scale& scale,
                                        const QLocale& locale = {});
/// "2 1 mm": the lengths in this unit, as typedDashes() reads them.
QString dashesText(std::span<const double> dashes, const Scale& scale);

} // namespace app
