// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/export_steps.h"

#include "app/base/latin.h"
#include "app/settings/remembered.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/microscope/export_steps_dialog.h"

#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

namespace ui {

namespace {

const QString folderKey = QStringLiteral("stepsFolder");

QString folder()
{
    const QString usual = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return app::rememberedFolder(folderKey, usual);
}

} // namespace

StepExports::StepExports(QWidget& window, const app::Microscope& microscope)
    : QObject(&window), window_(window), microscope_(microscope),
      questions_(std::make_unique<Questions>(window)), background_(&window)
{
}

void StepExports::ask()
{
    app::TraceExport trace{.tracedLine = microscope_.tracedLine(),
                           .narration = microscope_.narration()};
    if (lookOf(window_.palette()).dark)
        trace.ground = app::Ground::Dark;
    auto* dialog = new ExportStepsDialog(std::move(trace), microscope_.step(), &window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this,
            [this, dialog] { write(dialog->format(), dialog->trace()); });
    dialog->open();
}

/// The paths to write to, after asking about existing files; empty: cancelled.
QStringList StepExports::pathsFor(const app::TraceFormat& format, const app::TraceExport& trace)
{
    const QString ending = app::latin(format.ending);
    const bool several = format.files == app::TraceFormat::Files::OneAStep && !trace.only;
    const QString inFolder = folder() + u'/';
    const QString path =
        several ? questions_->filesToWrite(Text::tr("Choose how the file names begin"),
                                           inFolder + app::traceStem(trace) + u'.' + ending,
                                           format.name, ending)
                : questions_->fileToWrite(Text::tr("Export steps"),
                                          app::tracePaths(trace, format, inFolder).front(),
                                          format.name, ending);
    if (path.isEmpty())
        return {};
    QSettings().setValue(folderKey, QFileInfo(path).path());
    const QStringList paths = app::tracePaths(trace, format, path);
    const QStringList existing = several ? app::existingOf(paths) : QStringList();
    return existing.isEmpty() || questions_->overwriteFiles(existing, int(paths.size()))
               ? paths
               : QStringList();
}

void StepExports::write(const app::TraceFormat& format, const app::TraceExport& trace)
{
    const QStringList paths = pathsFor(format, trace);
    if (paths.isEmpty())
        return;
    using Painted = std::optional<std::vector<QByteArray>>; // empty: not enough memory
    background_.run(
        Text::tr("Painting %n steps…", nullptr, int(trace.steps().size())),
        [&format, trace](const app::Follower&) { return app::traceBytes(trace, format); },
        [this, paths](const std::optional<Painted>& painted) {
            if (painted) // otherwise cancelled before anything is written
                writePainted(paths, *painted);
        },
        InBackground::Cancel::Drops);
}

void StepExports::writePainted(const QStringList& paths,
                               const std::optional<std::vector<QByteArray>>& bytes)
{
    const auto error =
        bytes ? app::writeTrace(paths, *bytes)
              : std::optional(
                  Text::tr("There is not enough memory for the pictures. Export fewer steps."));
    if (error)
        emit told({Message::Kind::Warning, *error});
    else
        emit told({Message::Kind::Done, paths.size() == 1
                                            ? Text::tr("Wrote %1.").arg(paths.front())
                                            : Text::tr("Wrote %n files, the first of them %1.",
                                                       nullptr, int(paths.size()))
                                                  .arg(paths.front())});
}

} // namespace ui

#include "moc_export_steps.cpp"
