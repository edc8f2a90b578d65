// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/chart.h"
#include "app/view/chart_look.h"

#include <QIODevice>
#include <QSizeF>

#include <span>

namespace app {

/// One row of the catalogue of what a chart can be saved as.
struct ChartFormat {
    std::string_view key; ///< "svg": the file name's ending
    QString name;         ///< "SVG drawing", translated
    /// Nothing, or why it could not be done. `size` is in logical pixels (1/96 inch).
    std::optional<QString> (*write)(const Chart& chart, const ChartLook& look, const QSizeF& size,
                                    QIODevice& out);
};

/// Every format, in menu order.
std::span<const ChartFormat> chartFormats();
const ChartFormat* findChartFormat(QStringView key);

/// A size in which a chart looks well, margins included: 720 pixels wide.
QSizeF usualSize(const Chart& chart, const ChartLook& look);

/// The whole file in memory, for reports.
QByteArray chartBytes(const Chart& chart, const ChartFormat& format, const ChartLook& look);

/// Writes a file in the format that its ending says; an existing one is replaced only by a whole
/// new one. Nothing, or the sentence that names the file and says what to do.
std::optional<QString> writeChart(const Chart& chart, const QString& path, const ChartLook& look);

} // namespace app
