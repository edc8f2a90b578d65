// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment/exports.h"

#include "app/base/text.h"
#include "app/charts/study_charts.h"
#include "app/settings/remembered.h"
#include "ui/look/text.h"

#include <QFileInfo>
#include <QMenu>
#include <QSettings>
#include <QStandardPaths>

#include <algorithm>

namespace ui {

namespace {

using Written = app::Result<QStringList>;

/// The menu text of a row for a study, with the number of files.
QString entryText(const app::StudyFile& row, const app::Study& study)
{
    using Group = app::StudyFile::Group;
    if (row.group == Group::Report)
        return Text::tr("Report as %1…").arg(row.name);
    const bool tables = row.group == Group::Tables;
    const int parts = int(tables ? app::tablesOf(study).size() : app::chartsOf(study).size());
    const int files = int(row.paths(study, QStringLiteral("/any.") + row.ending).size());
    const QString what = tables ? Text::tr("All %n tables as %1", nullptr, parts)
                                : Text::tr("All %n charts as %1", nullptr, parts);
    return files == 1 ? Text::tr("%1 (one file)…").arg(what.arg(row.name))
                      : Text::tr("%1 (%n files)…", nullptr, files).arg(what.arg(row.name));
}

QString proposal(const QString& name, const QString& ending)
{
    const QString usual = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    const QString folder = app::rememberedFolder(QStringLiteral("experimentFolder"), usual);
    return QStringLiteral("%1/%2.%3").arg(folder, name, ending);
}

} // namespace

Exports::Exports(QWidget& window)
    : QObject(&window), window_(window), questions_(std::make_unique<Questions>(window)),
      background_(&window)
{
}

QMenu* Exports::menu(const Current& current)
{
    auto* menu = new QMenu(&window_);
    addShown(*menu, current);
    addStudy(*menu, current);
    return menu;
}

void Exports::addShown(QMenu& menu, const Current& current)
{
    const auto add = [&](const QString& text, const QString& key, auto&& of, auto&& write) {
        auto* action = menu.addAction(text);
        action->setObjectName(QStringLiteral("export-shown-%1").arg(key));
        connect(action, &QAction::triggered, this, [current, write, of] {
            if (const auto* shown = current().*of)
                write(*shown);
        });
        connect(&menu, &QMenu::aboutToShow, action,
                [action, current, of] { action->setVisible(current().*of != nullptr); });
    };
    for (const app::TableFormat& format : app::tableFormats())
        if (format.key != u"text")
            add(Text::tr("This table as %1…").arg(format.name), format.ending, &Shown::table,
                [this, format](const app::Table& table) { writeTable(table, format); });
    for (const app::ChartFormat& format : app::chartFormats())
        add(Text::tr("This chart as %1…").arg(format.name), app::latin(format.key), &Shown::chart,
            [this, format](const app::Chart& chart) { writeChart(chart, format); });
}

void Exports::addStudy(QMenu& menu, const Current& current)
{
    std::optional<app::StudyFile::Group> last;
    for (const app::StudyFile& row : app::studyFiles()) {
        if (last != row.group)
            menu.addSeparator();
        last = row.group;
        auto* action = menu.addAction(row.name);
        action->setObjectName(QStringLiteral("export-%1-%2").arg(int(row.group)).arg(row.ending));
        connect(action, &QAction::triggered, this,
                [this, row, current] { writeStudy(row, current().study); });
        connect(&menu, &QMenu::aboutToShow, action, [action, row, current] {
            if (const auto study = current().study)
                action->setText(entryText(row, *study));
        });
    }
}

/// Remembers the folder for the next proposal.
QString Exports::remembered(const QString& path)
{
    if (!path.isEmpty())
        QSettings().setValue("experimentFolder", QFileInfo(path).path());
    return path;
}

void Exports::writeTable(const app::Table& table, const app::TableFormat& format)
{
    const QString path = remembered(questions_->fileToWrite(
        Text::tr("Export"), proposal(table.key, format.ending), format.name, format.ending));
    if (path.isEmpty())
        return;
    const auto error = app::writeTable(table, format, path);
    tell(error ? Written::failure(*error) : Written::of({path}));
}

void Exports::writeChart(const app::Chart& chart, const app::ChartFormat& format)
{
    const QString ending = app::latin(format.key);
    const QString path = remembered(questions_->fileToWrite(
        Text::tr("Export"), proposal(chart.key, ending), format.name, ending));
    if (path.isEmpty())
        return;
    const auto error = app::writeChart(chart, path, app::chartLook(app::Ground::Light));
    tell(error ? Written::failure(*error) : Written::of({path}));
}

void Exports::exportChart(const app::Chart& chart)
{
    writeChart(chart, app::chartFormats().front());
}

/// The path to write to, after asking about existing files; empty: cancelled.
QString Exports::pathFor(const app::StudyFile& row, const app::Study& study)
{
    const QString proposed = proposal(QStringLiteral("clearcut"), row.ending);
    const int files = int(row.paths(study, proposed).size());
    if (files == 1)
        return remembered(
            questions_->fileToWrite(Text::tr("Export"), proposed, row.name, row.ending));
    const QString path = remembered(questions_->filesToWrite(
        Text::tr("Choose how the names of the %n files begin", nullptr, files), proposed, row.name,
        row.ending));
    if (path.isEmpty())
        return {};
    const QStringList paths = row.paths(study, path);
    QStringList existing;
    std::ranges::copy_if(paths, std::back_inserter(existing),
                         [](const QString& one) { return QFileInfo::exists(one); });
    return existing.isEmpty() || questions_->overwriteFiles(existing, files) ? path : QString();
}

void Exports::writeStudy(const app::StudyFile& row, const std::shared_ptr<const app::Study>& study)
{
    const QString path = study ? pathFor(row, *study) : QString();
    if (path.isEmpty())
        return;
    background_.run(
        Text::tr("Writing…"),
        [study, row, path](const app::Follower& follower) {
            return row.write(*study, path, follower.stop);
        },
        [this](const std::optional<Written>& written) { tell(written.value()); },
        InBackground::Cancel::Stops);
}

void Exports::tell(const Written& written)
{
    if (!written)
        return emit told({Message::Kind::Warning, written.error});
    const QStringList& paths = *written.value;
    if (paths.isEmpty()) // cancelled before the first
        return;
    emit told({Message::Kind::Done,
               paths.size() == 1
                   ? Text::tr("Wrote %1.").arg(paths.front())
                   : Text::tr("Wrote %n files, the first of them %1.", nullptr, int(paths.size()))
                         .arg(paths.front())});
}

} // namespace ui

#include "moc_exports.cpp"
