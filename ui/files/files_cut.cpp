// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/crop_to_window.h"
#include "app/comparison/cut_text.h"
#include "app/formats/export_cut.h"
#include "ui/files/files.h"

#include <QFileInfo>

#include <new>

namespace ui {

app::CutOptions Files::cutOptions() const
{
    app::CutOptions options{.clipAll = session_.uses().clipAll};
    options.region = app::regionOf(session_.now().windows(), session_.now().page());
    return options;
}

void Files::exportCut()
{
    background_.inTurn([this](const Turn& turn) {
        emit documentWanted();
        const QString path =
            questions_->fileToSave(tr("Export cut drawing"), proposal(QStringLiteral("-cut.svg")),
                                   Questions::Formats::All);
        if (path.isEmpty())
            return;
        const QString name = QFileInfo(path).fileName();
        background_.run(
            tr("Exporting %1…").arg(name),
            [document = session_.now(), options = cutOptions(),
             path](const app::Follower& follower) {
                return app::exportCut(document, options, path, follower.stop);
            },
            [this, name, turn](const std::optional<app::CutExport>& made) {
                const app::CutExport& cut = made.value();
                if (cut.end == app::CutExport::End::Failed)
                    emit told({Message::Kind::Warning, cut.error});
                else if (cut.end == app::CutExport::End::Written)
                    emit told({Message::Kind::Done,
                               tr("Exported %1: %2").arg(name, app::cutText(cut.counts))});
            },
            InBackground::Cancel::Stops);
    });
}

void Files::crop()
{
    background_.inTurn([this](const Turn& turn) { cropNow(turn); });
}

void Files::cropNow(const Turn& turn)
{
    emit documentWanted();
    app::CutOptions options = cutOptions();
    options.scope = app::CutScope::Editable;
    using Cropped = std::optional<app::Cut>; // empty: not enough memory
    background_.run(
        tr("Cropping…"),
        [document = session_.now(), options](const app::Follower&) -> Cropped {
            try {
                return app::cut(document, options);
            } catch (const std::bad_alloc&) {
                return std::nullopt;
            }
        },
        [this, turn, document = session_.now()](std::optional<Cropped> cut) {
            if (!cut)
                return;
            if (!*cut)
                return emit told({Message::Kind::Warning,
                                  tr("The drawing was not cropped: there is not enough memory. "
                                     "Close other programs, and crop again.")});
            if (!sameAddress(document, session_.now())) // not by the person, who had to wait
                return cropNow(turn);
            showCrop(std::move(**cut));
        },
        InBackground::Cancel::Drops);
}

void Files::showCrop(app::Cut cut)
{
    auto command = std::make_unique<app::CropToWindow>(session_.document, std::move(cut));
    const app::CutCounts counts = command->counts();
    if (const QString leftAlone = app::leftAloneText(counts); !command->changes())
        return emit told({Message::Kind::Done,
                          leftAlone.isEmpty()
                              ? tr("Nothing was cropped: the clip window keeps all of the drawing.")
                              : tr("Nothing was cropped.") + leftAlone});
    session_.history.push(command.release());
    emit told({Message::Kind::Done, tr("Cropped: %1").arg(app::cutText(counts))});
}

} // namespace ui
