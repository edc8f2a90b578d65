// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/files.h"
#include "ui/look/text.h"

#include <QFileInfo>

namespace ui {

void Files::recover(const app::Leftover& leftover, const std::function<void(Recovered)>& recovered)
{
    using Read = app::Result<app::Recovered>;
    background_.inTurn([this, leftover, recovered](const Turn& turn) {
        background_.run(
            Text::tr("Recovering %1…").arg(leftover.origin.name),
            [leftover](const app::Follower&) { return app::recover(leftover); },
            [this, leftover, recovered, turn](std::optional<Read> read) {
                auto end = Recovered::NotAtAll;
                if (read && *read) {
                    const bool whole = read->value->lost.isEmpty();
                    if (showRecovered(std::move(*read->value), leftover))
                        end = whole ? Recovered::Wholly : Recovered::Partly;
                } else if (read) {
                    setAside(leftover, read->error);
                }
                recovered(end);
            },
            InBackground::Cancel::Drops);
    });
}

// Undo may lead back to the saved state, but only if the file is still as it was saved. A drawing
// that lacks something must not replace a file that may have it: Save asks for a new name.
bool Files::showRecovered(app::Recovered recovered, const app::Leftover& leftover)
{
    const app::Origin& origin = leftover.origin;
    const QString path = recovered.lost.isEmpty() ? origin.path : QString();
    app::RecordedHistory& history = recovered.history;
    const bool sameFile = path.isEmpty() || QFileInfo(path).lastModified() == origin.fileTime;
    if (!sameFile || !recovered.lost.isEmpty() || history.clean == history.index)
        history.clean.reset();
    if (!show({std::move(recovered.document), {}}, path, path.isEmpty() ? origin.name : QString()))
        return false;
    seen_ = origin.fileTime;
    app::restore(session_.history, session_.document, std::move(history));
    tellRecovered(recovered.lost, leftover);
    return true;
}

void Files::tellRecovered(const QString& lost, const app::Leftover& leftover)
{
    const QString& name = leftover.origin.name;
    if (!lost.isEmpty())
        return emit told(
            {Message::Kind::Warning,
             Text::tr("%1 was recovered from damaged files, and %2. The files are kept in "
                      "%3. Save the drawing under a new name.")
                 .arg(name, lost, QFileInfo(leftover.file).path())});
    const QFileInfo file(session_.path());
    if (file.exists() && file.lastModified() != seen_)
        return emit told(
            {Message::Kind::Warning,
             Text::tr("Recovered %1. Another program has changed its file since.").arg(name),
             Text::tr("Save as…"), [this] { saveAs(); }});
    emit told({Message::Kind::Done, Text::tr("Recovered %1. Save it to keep it.").arg(name)});
}

void Files::setAside(app::Leftover leftover, const QString& error)
{
    const QString aside = app::setAside(leftover);
    emit told(
        {Message::Kind::Warning, Text::tr("%1 cannot be recovered: %2 Its file is kept as %3.")
                                     .arg(leftover.origin.name, error, aside)});
}

} // namespace ui
