// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/files.h"

namespace ui {

void Files::recover(const app::Leftover& leftover, const Answer& recovered)
{
    using Read = app::Result<app::Imported>;
    background_.inTurn([this, leftover, recovered](const Turn& turn) {
        background_.run(
            tr("Recovering %1…").arg(leftover.origin.name),
            [file = leftover.file](const app::Follower&) {
                return app::readFile(file, &app::formats().front());
            },
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

void Files::showRecovered(app::Imported imported, const app::Origin& origin)
{
    show(std::move(imported), origin.path, origin.path.isEmpty() ? origin.name : QString());
    seen_ = origin.fileTime;
    session_.history.resetClean(); // mark as unsaved
    emit told({Message::Kind::Done, tr("Recovered %1. Save it to keep it.").arg(origin.name)});
}

void Files::setAside(app::Leftover leftover, const QString& error)
{
    const QString aside = app::setAside(leftover);
    emit told({Message::Kind::Warning, tr("%1 cannot be recovered: %2 Its file is kept as %3.")
                                           .arg(leftover.origin.name, error, aside)});
}

} // namespace ui
