// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/chart.h"
#include "app/tables/table.h"

#include <QIODevice>

namespace app {

/// A part of a report, shown in this order. What is empty is left out.
struct ReportSection {
    QString title;
    QStringList sentences{}; ///< a paragraph each
    QString code{};          ///< lines to copy
    std::vector<Chart> charts{};
    std::vector<Table> tables{};
};

/// Something to read, print and keep: plain data.
struct Report {
    QString title;
    QStringList summary{}; ///< sentences for who reads nothing else
    std::vector<ReportSection> sections;
};

/// A field of a table as people read it: numbers with a real minus.
QString readable(const QString& field, bool numeric);

/// One row of the catalogue of what a report can be.
struct ReportFormat {
    QString key;  ///< "html": of --report, and the ending of a file's name
    QString name; ///< "Web page", translated
    /// Writes one file that needs no other. Nothing, or why it could not be done. Needs a
    /// QGuiApplication, for the fonts of charts.
    std::optional<QString> (*write)(const Report& report, QIODevice& out);
};

/// Every format, in menu order.
std::vector<ReportFormat> reportFormats();

/// The one that a file's name asks for by its ending, or nothing.
std::optional<ReportFormat> reportFormatOf(const QString& path);

/// Writes the file that the ending of its name asks for; an existing one is replaced only by a
/// whole new one. Nothing, or the sentence that names the file and says what to do.
std::optional<QString> writeReport(const Report& report, const QString& path);

} // namespace app
