// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/study_files.h"

#include "app/charts/chart_file.h"
#include "app/charts/study_charts.h"
#include "app/formats/replace_file.h"
#include "app/formats/write_all.h"
#include "app/report/study_report.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace app {
namespace {

struct StudyFiles {
    Q_DECLARE_TR_FUNCTIONS(StudyFiles)
};

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
    return error ? std::optional(StudyFiles::tr("Cannot write %1: %2").arg(path, *error)) : error;
}

/// The circumstances are facts of every table.
Written writeTables(const TableFormat& format, const Study& study, const QString& path)
{
    const auto tables = tablesOf(study);
    if (format.key != u"csv") { // the others keep tables apart in one file
        const auto error = writeText(path, format.text(tables));
        return error ? Written::failure(*error) : Written::of({path});
    }
    QStringList paths;
    for (const Table& table : tables) {
        paths << pathFor(path, table.key);
        if (const auto error = writeText(paths.back(), format.text(std::span(&table, 1))))
            return Written::failure(*error);
    }
    return Written::of(paths);
}

Written writeCharts(const Study& study, const QString& path)
{
    QStringList paths;
    for (const Chart& chart : chartsOf(study)) {
        paths << pathFor(path, chart.key);
        if (const auto error = writeChart(chart, paths.back(), chartLook(Ground::Light)))
            return Written::failure(*error);
    }
    return Written::of(paths);
}

} // namespace

std::vector<StudyFile> studyFiles()
{
    std::vector<StudyFile> rows;
    for (const TableFormat& format : tableFormats())
        if (format.key != u"text")
            rows.push_back({StudyFile::Group::Tables, format.name, format.ending,
                            [format](const Study& study, const QString& path) {
                                return writeTables(format, study, path);
                            }});
    for (const ChartFormat& format : chartFormats())
        rows.push_back({StudyFile::Group::Charts, format.name,
                        QString::fromUtf8(format.key.data(), qsizetype(format.key.size())),
                        writeCharts});
    for (const ReportFormat& format : reportFormats())
        rows.push_back({StudyFile::Group::Report, format.name, format.key,
                        [](const Study& study, const QString& path) {
                            const auto error = writeReport(reportOf(study), path);
                            return error ? Written::failure(*error) : Written::of({path});
                        }});
    return rows;
}

} // namespace app
