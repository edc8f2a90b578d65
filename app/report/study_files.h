// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"
#include "app/experiment/study.h"
#include "app/tables/table.h"

#include <functional>
#include <stop_token>

namespace app {

/// One row of the catalogue of file formats of a study.
struct StudyFile {
    enum class Group : std::uint8_t { Tables, Charts, Report };
    Group group;
    QString name;   ///< "CSV", translated
    QString ending; ///< of the file's name
    /// The files that `write` creates for `path`: that file, or one for each table or chart.
    std::function<QStringList(const Study& study, const QString& path)> paths;
    /// Writes the study to `path`, replacing existing files only by complete new ones. Returns all
    /// files, or a sentence that says what failed. If each table or chart has a file of its own,
    /// "times.csv" becomes "times-table1-clip-published.csv" and so on. A stop request leaves out
    /// the files not begun yet.
    std::function<Result<QStringList>(const Study& study, const QString& path,
                                      const std::stop_token& stop)>
        write;
};

/// Tables in every format except text, then charts, then reports.
std::vector<StudyFile> studyFiles();

/// Writes one table to a file. Empty, or a sentence that says what failed.
std::optional<QString> writeTable(const Table& table, const TableFormat& format,
                                  const QString& path);

} // namespace app
