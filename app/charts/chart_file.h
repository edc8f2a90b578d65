// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/file_kind.h"
#include "app/charts/chart.h"
#include "app/view/chart_look.h"

#include <QSizeF>

namespace app {

/// One row of the catalogue of file formats of charts. The size is in logical pixels (1/96 inch).
using ChartFormat = FileKind<Chart, ChartLook, QSizeF>;

/// Every format, in menu order.
std::span<const ChartFormat> chartFormats();

/// The natural size of a chart with margins: 720 logical pixels wide.
QSizeF usualSize(const Chart& chart, const ChartLook& look);

/// The whole file in memory, for reports.
QByteArray chartBytes(const Chart& chart, const ChartFormat& format, const ChartLook& look);

/// `writeAs`, in its usual size.
std::optional<QString> writeChart(const Chart& chart, const QString& path, const ChartLook& look);

} // namespace app
