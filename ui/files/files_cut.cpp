// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/crop_to_window.h"
#include "app/comparison/cut_text.h"
#include "app/formats/export_cut.h"
#include "ui/files/files.h"
#include "ui/look/text.h"

#include <QFileInfo>

#include <new>

namespace ui {

app::CutOptions Files::cutAs(MakeOptions make) const
{
    const app::Document& document = session_.now();
    app::CutOptions options = make(session_.display().cutting, document.page());
    options.clipAll = session_.uses().clipAll;
    app::cutAt(options, document.windows(), document.page());
    return options;
}

void Files::exportCut()
{
    background_.inTurn([this](const Turn& turn) {
        emit documentWanted();
        const QString path =
            questions_->fileToSave(Text::tr("Export cut drawing"),
                                   proposal(QStringLiteral("-cut.svg")), Questions::Formats::All);
        if (path.isEmpty())
            return;
        const QString name = QFileInfo(path).fileName();
        background_.run(
            Text::tr("Exporting %1…").arg(name),
            [document = session_.now(), options = cutAs(app::exportOptions),
             path](const app::Follower& follower) {
                return app::exportCut(document, options, path, follower);
            },
            [this, name, turn](const std::optional<app::CutExport>& made) {
                const app::CutExport& cut = made.value();
                if (cut.end == app::CutExport::End::Failed)
                    emit told({Message::Kind::Warning, cut.error});
                else if (cut.end == app::CutExport::End::Written)
                    emit told({Message::Kind::Done,
                               Text::tr("Exported %1: %2").arg(name, app::cutText(cut.counts))});
            },
            InBackground::Cancel::Stops);
    });
}

void Files::cutPermanently(const app::PermanentCut& kind)
{
    background_.inTurn([this, &kind](const Turn& turn) { cutNow(kind, turn); });
}

void Files::cutNow(const app::PermanentCut& kind, const Turn& turn)
{
    emit documentWanted();
    const app::CutOptions options = cutAs(app::permanentOptions);
    using Cropped = std::optional<app::Cut>; // empty: not enough memory
    background_.run(
        Text::tr("Cutting…"),
        [document = session_.now(), options, &kind](const app::Follower& follower) -> Cropped {
            try {
                return kind.make(document, options, follower);
            } catch (const std::bad_alloc&) {
                return std::nullopt;
            }
        },
        [this, &kind, turn, document = session_.now()](std::optional<Cropped> cut) {
            if (!cut)
                return;
            if (!*cut)
                return emit told({Message::Kind::Warning,
                                  Text::tr("The drawing was not cut: there is not enough memory. "
                                           "Close other programs, and try again.")});
            if (!sameAddress(document, session_.now())) // not by the person, who had to wait
                return cutNow(kind, turn);
            showCut(std::move(**cut), kind);
        },
        InBackground::Cancel::Drops);
}

void Files::showCut(app::Cut cut, const app::PermanentCut& kind)
{
    auto command = std::make_unique<app::CropToWindow>(session_.document, std::move(cut), kind);
    const app::CutCounts counts = command->counts();
    if (!command->changes()) {
        const QString leftAlone = app::leftAloneText(counts);
        return emit told({Message::Kind::Done,
                          Text::tr(kind.nothing)
                              + (leftAlone.isEmpty() ? QStringLiteral(": ") + Text::tr(kind.why)
                                                     : u'.' + leftAlone)});
    }
    session_.history.push(command.release());
    emit told({Message::Kind::Done, Text::tr(kind.done).arg(app::cutText(counts))});
}

} // namespace ui
