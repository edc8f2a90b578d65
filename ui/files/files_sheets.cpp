// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tiles/empty_sheets.h"
#include "app/tiles/sheet_export.h"
#include "ui/files/files.h"
#include "ui/look/text.h"

#include <QDir>
#include <QFileInfo>

// Writing the sheets of a drawing that is larger than the paper.

namespace ui {

void Files::exportSheets(const app::Sheets& sheets, const QString& pattern)
{
    background_.inTurn([=, this](const Turn& turn) {
        emit documentWanted();
        const bool oneFile = !app::namesEverySheet(pattern, sheets.tiling);
        if (oneFile) {
            const QString path =
                questions_->fileToWrite(Text::tr("Export sheets"), QDir(folder()).filePath(pattern),
                                        Text::tr("PDF document"), QFileInfo(pattern).suffix());
            if (!path.isEmpty())
                writeSheets(sheets, path, turn);
            return;
        }
        const QString chosen =
            questions_->folderToWrite(Text::tr("Export sheets to folder"), folder());
        if (chosen.isEmpty())
            return;
        const QString path = QDir(chosen).filePath(pattern);
        const QStringList all = app::filesOf(sheets, path);
        QStringList existing;
        for (const QString& file : all)
            if (QFileInfo::exists(file))
                existing << file;
        if (existing.isEmpty() || questions_->overwriteFiles(existing, int(all.size())))
            writeSheets(sheets, path, turn);
    });
}

void Files::writeSheets(const app::Sheets& sheets, const QString& path, const Turn& turn)
{
    const QStringList all = app::filesOf(sheets, path);
    QString names = QFileInfo(all.front()).fileName();
    if (all.size() > 1)
        names += QStringLiteral(" … ") + QFileInfo(all.back()).fileName();
    const auto pages = int(sheets.count());
    background_.run(
        pages == 1 ? Text::tr("Exporting 1 sheet…") : Text::tr("Exporting %1 sheets…").arg(pages),
        [sheets, path](const app::Follower& follower) {
            return app::exportSheets(sheets, path, follower);
        },
        [this, names, pages, turn, empty = app::emptySheetsText(sheets.tiling)](
            const std::optional<app::WriteResult>& written) {
            const app::WriteResult& result = written.value();
            if (result.end != app::WriteResult::End::Written)
                emit told({Message::Kind::Warning, result.error});
            else {
                const QString sentence =
                    pages == 1 ? Text::tr("Exported 1 sheet: %1").arg(names)
                               : Text::tr("Exported %1 sheets: %2").arg(pages).arg(names);
                emit told({Message::Kind::Done,
                           empty.isEmpty() ? sentence : sentence + QStringLiteral(". ") + empty});
            }
        },
        InBackground::Cancel::Stops);
}

} // namespace ui
