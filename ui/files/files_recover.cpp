// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/files.h"

#include <QFileInfo>

namespace ui {

void Files::recover(const app::Leftover& leftover, const Answer& recovered)
{
    using Read = app::Result<app::Recovered>;
    background_.inTurn([this, leftover, recovered](const Turn& turn) {
        background_.run(
            tr("Recovering %1…").arg(leftover.origin.name),
            [leftover](const app::Follower&) { return app::recover(leftover); },
            [this, leftover, recovered, turn](std::optional<Read> read) {
                if (read && *read)
                    showRecovered(std::move(*read->value), leftover.origin);
                else if (read)
                    setAside(leftover, read->error);
                recovered(read && *read);
            },
            InBackground::Cancel::Drops);
    });
}

// Undo may lead back to the saved state, but only if the file is still as it was saved.
void Files::showRecovered(app::Recovered recovered, const app::Origin& origin)
{
    app::RecordedHistory& history = recovered.history;
    const bool sameFile =
        origin.path.isEmpty() || QFileInfo(origin.path).lastModified() == origin.fileTime;
    if (!sameFile || history.clean == history.index)
        history.clean.reset();
    show({std::move(recovered.document), {}}, origin.path,
         origin.path.isEmpty() ? origin.name : QString());
    seen_ = origin.fileTime;
    app::restore(session_.history, session_.document, std::move(history));
    emit told({Message::Kind::Done, tr("Recovered %1. Save it to keep it.").arg(origin.name)});
}

void Files::setAside(app::Leftover leftover, const QString& error)
{
    const QString aside = app::setAside(leftover);
    emit told({Message::Kind::Warning, tr("%1 cannot be recovered: %2 Its file is kept as %3.")
                                           .arg(leftover.origin.name, error, aside)});
}

} // namespace ui
