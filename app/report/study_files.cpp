// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/study_files.h"

#include "app/base/replace_file.h"
#include "app/base/text.h"
#include "app/base/write_all.h"
#include "app/charts/chart_file.h"
#include "app/charts/study_charts.h"
#include "app/report/study_report.h"

#include <QFileInfo>

namespace app {
namespace {

using Written = Result<QStringList>;

QString pathFor(const QString& path, const QString& key)
{
    const QFileInfo info(path);
    return QStringLiteral("%1/%2-%3.%4")
        .arg(info.path(), info.completeBaseName(), key, info.suffix());
}

std::optional<QString> writeText(const QString& path, const QString& text)
{
    const auto error = replaceFile(path, [&](QIODevice& out) {
        return writeAll(out, text.toStdString()) ? std::nullopt
                                                 : std::optional(out.errorString() + u'.');
    });
    return error ? std::optional(Text::tr("Cannot write %1: %2").arg(path, *error)) : error;
}

QStringList tablePaths(const TableFormat& format, const Study& study, const QString& path)
{
    if (format.key != u"csv") // the other formats keep tables apart in one file
        return {path};
    QStringList paths;
    for (const Table& table : tablesOf(study))
        paths << pathFor(path, table.key);
    return paths;
}

QStringList chartPaths(const Study& study, const QString& path)
{
    QStringList paths;
    for (const Chart& chart : chartsOf(study))
        paths << pathFor(path, chart.key);
    return paths;
}

/// Writes the files in turn by `write(i)`, until one fails or a stop is requested.
Written writeEach(const QStringList& paths, const std::stop_token& stop,
                  const std::function<std::optional<QString>(qsizetype)>& write)
{
    for (qsizetype i = 0; i < paths.size(); ++i) {
        if (stop.stop_requested())
            return Written::of(paths.first(i));
        if (const auto error = write(i))
            return Written::failure(*error);
    }
    return Written::of(paths);
}

/// The circumstances become facts of every table.
Written writeTables(const TableFormat& format, const Study& study, const QString& path,
                    const std::stop_token& stop)
{
    const auto tables = tablesOf(study);
    const QStringList paths = tablePaths(format, study, path);
    const bool together = paths == QStringList{path};
    return writeEach(paths, stop, [&](qsizetype i) {
        return together ? writeText(path, format.text(tables))
                        : writeTable(tables[std::size_t(i)], format, paths[i]);
    });
}

Written writeCharts(const Study& study, const QString& path, const std::stop_token& stop)
{
    const auto charts = chartsOf(study);
    const QStringList paths = chartPaths(study, path);
    return writeEach(paths, stop, [&](qsizetype i) {
        return writeChart(charts[std::size_t(i)], paths[i], chartLook(Ground::Light));
    });
}

} // namespace

std::optional<QString> writeTable(const Table& table, const TableFormat& format,
                                  const QString& path)
{
    return writeText(path, format.text(std::span(&table, 1)));
}

std::vector<StudyFile> studyFiles()
{
    std::vector<StudyFile> rows;
    for (const TableFormat& format : tableFormats())
        if (format.key != u"text")
            rows.push_back(
                {StudyFile::Group::Tables, format.name, format.ending,
                 [format](const Study& study, const QString& path) {
                     return tablePaths(format, study, path);
                 },
                 [format](const Study& study, const QString& path, const std::stop_token& stop) {
                     return writeTables(format, study, path, stop);
                 }});
    for (const ChartFormat& format : chartFormats())
        rows.push_back(
            {StudyFile::Group::Charts, format.name, latin(format.key), chartPaths, writeCharts});
    for (const ReportFormat& format : reportFormats())
        rows.push_back({StudyFile::Group::Report, format.name, latin(format.key),
                        [](const Study&, const QString& path) { return QStringList{path}; },
                        [](const Study& study, const QString& path, const std::stop_token& stop) {
                            return writeEach({path}, stop, [&](qsizetype) {
                                return writeReport(reportOf(study), path);
                            });
                        }});
    return rows;
}

} // namespace app
