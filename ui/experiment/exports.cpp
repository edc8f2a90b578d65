// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment/exports.h"

#include "app/charts/chart_file.h"
#include "ui/dialogs/in_background.h"

#include <QFileInfo>
#include <QMenu>
#include <QSettings>
#include <QStandardPaths>

namespace ui {

namespace {

using Written = app::Result<QStringList>;

QString titleOf(app::StudyFile::Group group)
{
    using Group = app::StudyFile::Group;
    return group == Group::Tables   ? Exports::tr("Tables as")
           : group == Group::Charts ? Exports::tr("Charts as")
                                    : Exports::tr("Report as");
}

QString lastFolder()
{
    const QString usual = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QSettings().value("experimentFolder", usual).toString();
}

} // namespace

Exports::Exports(QWidget& window)
    : QObject(&window), window_(window), questions_(std::make_unique<Questions>(window))
{
}

QMenu* Exports::menu(Current current)
{
    auto* menu = new QMenu(&window_);
    std::optional<app::StudyFile::Group> last;
    for (const app::StudyFile& row : app::studyFiles()) {
        if (last != row.group)
            menu->addSection(titleOf(row.group));
        last = row.group;
        auto* action = menu->addAction(tr("%1…").arg(row.name));
        action->setObjectName(QStringLiteral("export-%1-%2").arg(int(row.group)).arg(row.ending));
        connect(action, &QAction::triggered, this,
                [this, row, current] { exportAs(row, current()); });
    }
    return menu;
}

/// Empty: cancelled.
QString Exports::askedPath(const QString& name, const QString& kind, const QString& ending)
{
    const QString proposal = QStringLiteral("%1/%2.%3").arg(lastFolder(), name, ending);
    const QString path = questions_->fileToWrite(tr("Export"), proposal, kind, ending);
    if (!path.isEmpty())
        QSettings().setValue("experimentFolder", QFileInfo(path).path());
    return path;
}

void Exports::exportAs(const app::StudyFile& row, const std::shared_ptr<const app::Study>& study)
{
    const QString path = askedPath(QStringLiteral("clearcut"), row.name, row.ending);
    if (path.isEmpty())
        return;
    const auto written = inBackground(&window_, tr("Writing…"),
                                      [study, row, path] { return row.write(*study, path); });
    if (written)
        tell(*written);
}

void Exports::exportChart(const app::Chart& chart)
{
    const app::ChartFormat& format = app::chartFormats().front();
    const QString ending = QString::fromUtf8(format.key.data(), qsizetype(format.key.size()));
    const QString path = askedPath(chart.key, format.name, ending);
    if (path.isEmpty())
        return;
    const auto error = app::writeChart(chart, path, app::chartLook(app::Ground::Light));
    tell(error ? Written::failure(*error) : Written::of({path}));
}

void Exports::tell(const Written& written)
{
    if (!written)
        return emit told({Message::Kind::Warning, written.error});
    const QStringList& paths = *written.value;
    emit told(
        {Message::Kind::Done,
         paths.size() == 1
             ? tr("Wrote %1.").arg(paths.front())
             : tr("Wrote %n files: %1 and so on.", nullptr, int(paths.size())).arg(paths.front())});
}

} // namespace ui
