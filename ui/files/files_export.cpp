// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/comparison/cut_text.h"
#include "app/session/clipboard.h"
#include "app/session/export_name.h"
#include "app/session/export_source.h"
#include "app/session/window_words.h"
#include "ui/files/files.h"
#include "ui/look/text.h"

#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>
#include <QSettings>

#include <algorithm>
#include <utility>

// Writing a part of the drawing in any format.

namespace ui {

void Files::exportTo(const app::ExportJob& job, const QString& path, Answer written)
{
    if (const QString why = refusalToWrite(path); !why.isEmpty()) {
        emit told({Message::Kind::Warning, why});
        return written ? written(false) : void();
    }
    background_.inTurn([=, this](const Turn& turn) {
        emit documentWanted();
        background_.run(
            Text::tr("Exporting %1…").arg(QFileInfo(path).fileName()),
            [job, path](const app::Follower& follower) {
                return app::exportFile(job, path, follower);
            },
            [this, job, path, written, turn](const std::optional<app::ExportResult>& made) {
                const bool done = made && made->end == app::WriteResult::End::Written;
                if (done) {
                    exported_ = app::DrawingExport{session_.path(), path, job.choice};
                    const auto& windows = job.source.document.windows().list;
                    exportedWindow_ = job.choice.area.window < windows.size()
                                          ? app::nameOf(windows[job.choice.area.window])
                                          : QString();
                    QSettings settings;
                    app::remember(settings, *exported_);
                }
                if (made)
                    tellExport(*made, path);
                if (written)
                    written(done);
            },
            InBackground::Cancel::Stops);
    });
}

void Files::tellExport(const app::ExportResult& end, const QString& path)
{
    if (end.end == app::WriteResult::End::Failed)
        emit told({Message::Kind::Warning, end.error});
    if (end.end != app::WriteResult::End::Written)
        return;
    const QString name = QFileInfo(path).fileName();
    if (end.cut)
        return tellCut(Text::tr("Exported %1: %2").arg(name, app::cutText(end.counts)));
    const QString size =
        QLocale().formattedDataSize(QFileInfo(path).size(), 1, QLocale::DataSizeSIFormat);
    emit told({Message::Kind::Done, Text::tr("Exported %1, %2.").arg(name, size)});
}

/// The window of the last export, whose number may be another one now; empty: it is not known.
std::optional<std::size_t> Files::exportedWindow() const
{
    const auto& windows = session_.windows().list;
    const auto isIt = [this](const app::ClipWindow& each) {
        return app::nameOf(each) == exportedWindow_;
    };
    const auto found = std::ranges::find_if(windows, isIt);
    if (!exported_ || std::ranges::count_if(windows, isIt) != 1)
        return std::nullopt;
    return std::size_t(found - windows.begin());
}

bool Files::exportAgain()
{
    const auto last = lastExport();
    if (!last)
        return false;
    emit documentWanted();
    app::ExportJob job{app::exportSourceOf(session_), last->choice};
    app::ExportArea& area = job.choice.area;
    if (area.part == app::ExportPart::Layer && !exported_)
        return false;
    if (area.part == app::ExportPart::Window) {
        const auto window = exportedWindow();
        if (!window)
            return false;
        area.window = *window;
    }
    exportTo(job, last->file);
    return true;
}

void Files::copyExport(const app::ExportJob& job)
{
    background_.inTurn([this, job](const Turn& turn) {
        emit documentWanted();
        using Content = app::Result<QByteArray>;
        background_.run(
            Text::tr("Copying…"),
            [job](const app::Follower& follower) { return app::exportedContent(job, follower); },
            [this, job, turn](const std::optional<Content>& made) {
                if (!made)
                    return;
                if (!*made)
                    return emit told({Message::Kind::Warning, made->error});
                const app::Format& format = app::formatOf(job.choice);
                QGuiApplication::clipboard()->setMimeData( // which takes ownership
                    app::copiedFile(format.key, *made->value).release());
                emit told(
                    {Message::Kind::Done, Text::tr("Copied as %1. Paste it in another program.")
                                              .arg(format.shortName())});
            },
            InBackground::Cancel::Drops);
    });
}

std::optional<app::DrawingExport> Files::lastExport() const
{
    return exported_ ? exported_ : app::lastExport(QSettings(), session_.path());
}

app::ExportChoice Files::usualExport() const
{
    const QSettings settings;
    app::ExportChoice choice = app::lastChoice(settings, app::lastFormat(settings));
    if (choice.area.part != app::ExportPart::Page) // it was of another drawing
        choice.area.part = app::ExportPart::Cut;
    return choice;
}

app::ExportChoice Files::usualExport(const app::Format& format) const
{
    return app::lastChoice(QSettings(), format.key);
}

QString Files::exportProposal(const app::ExportChoice& choice) const
{
    const QString ending = u'.' + app::latin(app::formatOf(choice).key);
    return proposal(app::exportName(choice.area, session_.now()) + ending);
}

} // namespace ui
