// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"
#include "app/experiment/study.h"
#include "app/tables/table.h"

#include <functional>

namespace app {

/// One row of the catalogue of what a study can be written as.
struct StudyFile {
    enum class Group : std::uint8_t { Tables, Charts, Report };
    Group group;
    QString name;   ///< "CSV", translated
    QString ending; ///< of the file's name
    /// The files that `write` makes of `path`: that one, or one a table or chart.
    std::function<QStringList(const Study& study, const QString& path)> paths;
    /// Writes what was asked for at `path`, replacing what is there only by whole new files; all of
    /// them, or the sentence that says what is wrong. Where each table or chart is a file of its
    /// own, "times.csv" becomes "times-table1-clip-published.csv" and so on.
    std::function<Result<QStringList>(const Study& study, const QString& path)> write;
};

/// Tables in every format but text, then charts, then reports.
std::vector<StudyFile> studyFiles();

/// Writes one table to a file, and nothing else. Nothing, or the sentence that says what is wrong.
std::optional<QString> writeTable(const Table& table, const TableFormat& format,
                                  const QString& path);

} // namespace app
