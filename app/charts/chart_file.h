// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/chart.h"
#include "app/view/chart_look.h"

#include <QIODevice>
#include <QSizeF>

#include <span>

namespace app {

/// One row of the catalogue of file formats of charts.
struct ChartFormat {
    std::string_view key; ///< "svg": the file name's ending
    QString name;         ///< "SVG drawing", translated
    /// Empty, or why it failed. `size` is in logical pixels (1/96 inch).
    std::optional<QString> (*write)(const Chart& chart, const ChartLook& look, const QSizeF& size,
                                    QIODevice& out);
};

/// Every format, in menu order.
std::span<const ChartFormat> chartFormats();
const ChartFormat* findChartFormat(QStringView key);

/// The natural size of a chart with margins: 720 logical pixels wide.
QSizeF usualSize(const Chart& chart, const ChartLook& look);

/// The whole file in memory, for reports.
QByteArray chartBytes(const Chart& chart, const ChartFormat& format, const ChartLook& look);

/// Writes a file in the format of its ending; replaces an existing file only by a complete new one.
/// Empty, or a sentence that names the file and says what to do.
std::optional<QString> writeChart(const Chart& chart, const QString& path, const ChartLook& look);

} // namespace app
