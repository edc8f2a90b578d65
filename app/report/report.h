// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/chart.h"
#include "app/tables/table.h"

#include <QIODevice>

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

/// One row of the catalogue of report formats.
struct ReportFormat {
    QString key;  ///< "html": value of --report, and the file's ending
    QString name; ///< "Web page", translated
    /// Writes one self-contained file. Empty, or why it failed. Needs a QGuiApplication for the
    /// fonts of charts.
    std::optional<QString> (*write)(const Report& report, QIODevice& out);
};

/// Every format, in menu order.
std::vector<ReportFormat> reportFormats();

/// The format of a file's ending, or empty.
std::optional<ReportFormat> reportFormatOf(const QString& path);

/// Writes a file in the format of its ending; replaces an existing file only by a complete new one.
/// Empty, or a sentence that names the file and says what to do.
std::optional<QString> writeReport(const Report& report, const QString& path);

} // namespace app
