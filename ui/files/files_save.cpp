// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "ui/files/files.h"
#include "ui/look/text.h"

#include <QFileInfo>

// Saving, and the question about unsaved changes.

namespace ui {

namespace {

bool isNative(const QString& path) { return app::formatOfFile(path) == &app::formats().front(); }

/// An answer that ends its turn after it was given.
Files::Answer inTurn(const InBackground::Turn& turn, Files::Answer answer)
{
    return [turn, answer = std::move(answer)](bool yes) {
        if (answer)
            answer(yes);
    };
}

} // namespace

void Files::mayClose(const Answer& answer)
{
    background_.inTurn([=, this](const Turn& turn) {
        keepChanges(turn, [answer](bool yes, const Turn&) { answer(yes); });
    });
}

void Files::save(Answer saved)
{
    background_.inTurn([=, this](const Turn& turn) { saveNow(inTurn(turn, saved)); });
}

void Files::saveAs(Answer saved)
{
    background_.inTurn([=, this](const Turn& turn) {
        emit documentWanted();
        askPath(inTurn(turn, saved));
    });
}

// The drawing stays alive while the question is open. A further step or another question withdraws
// it: the person goes on.
void Files::keepChanges(const Turn& turn, const Replacing& then)
{
    emit documentWanted();
    if (session_.history.isClean() || app::isUnchangedSample(sample_, session_.now()))
        return then(true, turn);
    questions_->endSaveChanges(Questions::Answer::Cancel);
    const auto follow = [this, then](Questions::Answer answer, const Turn& now) {
        if (answer == Questions::Answer::Save)
            return saveNow([then, now](bool saved) { then(saved, now); });
        then(answer == Questions::Answer::DontSave, now);
    };
    const auto answered = [this, follow, asking = std::weak_ptr(turn)](Questions::Answer answer) {
        if (const Turn now = asking.lock())
            return follow(answer, now);
        background_.inTurn([follow, answer](const Turn& later) { follow(answer, later); });
    };
    questions_->saveChanges(name(), answered);
}

void Files::saveNow(const Answer& saved)
{
    emit documentWanted();
    const QString path = session_.path();
    if (path.isEmpty() || !isNative(path))
        return askPath(saved);
    if (session_.mustSaveAs())
        return questions_->saveAsNewFile(session_.losses()) ? askPath(saved) : saved(false);
    const bool changedElsewhere =
        QFileInfo::exists(path) && QFileInfo(path).lastModified() != seen_;
    using Changed = Questions::ChangedFile;
    const auto answer = changedElsewhere ? questions_->aboutChangedFile(path) : Changed::Overwrite;
    if (answer == Changed::Overwrite)
        return write(path, saved);
    saved(false);
    if (answer == Changed::Reload)
        background_.inTurn([this, path](const Turn& turn) { read(path, turn); });
}

// Only the native format holds a whole drawing; another format would lose parts of it.
void Files::askPath(const Answer& saved)
{
    const app::Format& native = app::formats().front();
    const QString path = questions_->fileToWrite(
        Text::tr("Save as"), proposal(QStringLiteral(".svg")), native.name, app::latin(native.key));
    if (held_ && held_(path))
        emit told({Message::Kind::Warning, refusalToWrite(path)});
    else if (!path.isEmpty() && isNative(path))
        return write(path, saved);
    else if (!path.isEmpty())
        emit told(
            {Message::Kind::Warning, Text::tr("%1 was not saved, because drawings are saved only "
                                              "as SVG. “Export…” writes other types.")
                                         .arg(QFileInfo(path).fileName())});
    saved(false);
}

void Files::write(const QString& path, const Answer& saved)
{
    const bool deleted = path == session_.path() && seen_.isValid() && !QFileInfo::exists(path);
    watch_.pause();
    background_.run(
        Text::tr("Saving %1…").arg(QFileInfo(path).fileName()),
        [document = session_.beginSaving(), path](const app::Follower& follower) {
            return app::save(document, path, follower.stop);
        },
        [this, path, saved, deleted](const std::optional<app::Saved>& written) {
            noteSaved(written.value(), path);
            watch_.follow(session_.path(), seen_);
            const bool done = written->end == app::Saved::End::Written;
            if (done && deleted)
                emit told({Message::Kind::Done, Text::tr("%1 had been deleted; it was saved again.")
                                                    .arg(QFileInfo(path).fileName())});
            saved(done);
        },
        InBackground::Cancel::Stops);
}

void Files::noteSaved(const app::Saved& saved, const QString& path)
{
    if (saved.end == app::Saved::End::Failed)
        emit told({Message::Kind::Warning, saved.error});
    if (saved.end != app::Saved::End::Written)
        return;
    session_.endSaving(path);
    seen_ = saved.fileTime;
    title_.clear();
    sample_.clear();
    noteRecent();
    emit nameChanged();
    emit told({});
    if (session_.history.isClean()) // saved while the question was open
        questions_->endSaveChanges(Questions::Answer::DontSave);
}

} // namespace ui
