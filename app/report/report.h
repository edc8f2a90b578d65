// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/file_kind.h"
#include "app/charts/chart.h"
#include "app/tables/table.h"

namespace app {

/// A part of a report, shown in this order. Empty parts are left out.
struct ReportSection {
    QString title;
    QStringList sentences{}; ///< one paragraph each
    QString code{};          ///< lines to copy
    std::vector<Chart> charts{};
    std::vector<Table> tables{};
};

/// A report to read, print and keep: plain data.
struct Report {
    QString title;
    QStringList summary{}; ///< sentences for readers who read nothing else
    std::vector<ReportSection> sections;
};

/// A field of a table as it is displayed: numbers with a real minus.
QString readable(const QString& field, bool numeric);

/// One row of the catalogue of report formats, as one self-contained file. Needs a QGuiApplication
/// for the fonts of charts.
using ReportFormat = FileKind<Report>;

/// Every format, in menu order.
std::span<const ReportFormat> reportFormats();

/// `writeAs`.
std::optional<QString> writeReport(const Report& report, const QString& path);

} // namespace app
