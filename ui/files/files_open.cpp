// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/loss_text.h"
#include "app/session/last_page.h"
#include "app/session/open_file.h"
#include "ui/files/files.h"
#include "ui/look/text.h"

#include <QFileInfo>
#include <QSettings>

#include <new>

// Everything that replaces the drawing in the window.

namespace ui {

namespace {

constexpr double newPenMillimetres = 0.3; // the stroke width in a new drawing

/// On the page that was kept last.
app::Document emptyDrawing()
{
    return app::newDrawing(app::pageFromText(QSettings().value("page").toString()));
}

} // namespace

void Files::replace(std::function<void(const Turn&)> then)
{
    background_.inTurn([this, then = std::move(then)](const Turn& turn) {
        keepChanges(turn, [then](bool mayReplace, const Turn& now) {
            if (mayReplace)
                then(now);
        });
    });
}

/// False, and the drawing is empty: there is not enough memory.
bool Files::show(app::Imported imported, const QString& path, const QString& title,
                 std::optional<app::SceneBlockCache> blocks)
{
    title_ = title;
    number_ = 1;
    sample_.clear();
    try {
        session_.load(std::move(imported), path, std::move(blocks));
    } catch (const std::bad_alloc&) {
        title_.clear();
        watch_.follow({}, {});
        emit nameChanged();
        emit told(
            {Message::Kind::Warning,
             Text::tr("There is not enough memory to show %1. Close other programs, and open it "
                      "again.")
                 .arg(path.isEmpty() ? title : path)});
        return false;
    }
    session_.pen.style.width = newPenMillimetres / session_.now().page().millimetresPerUnit();
    seen_ = QFileInfo(path).lastModified();
    watch_.follow(path, seen_);
    emit nameChanged();
    emit told({});
    return true;
}

bool Files::isUnused() const
{
    const app::Document& drawing = session_.now();
    return opening_.isEmpty() && session_.path().isEmpty()
           && (sample_.isEmpty() ? session_.history.isClean() && drawing.objects().empty()
                                 : app::isUnchangedSample(sample_, drawing));
}

void Files::startNew(std::function<void()> started)
{
    if (Files* there = placeFor(); there != this)
        return there ? there->startNew(std::move(started)) : void();
    replace([this, started = std::move(started)](const Turn&) {
        if (show({emptyDrawing(), {}}, {}, {}) && started)
            started();
    });
}

void Files::clear() { show({emptyDrawing(), {}}, {}, {}); }

void Files::openMade(app::Document document, const QString& title,
                     std::function<void(app::Session*)> opened)
{
    if (Files* there = placeFor(); there != this)
        return there    ? there->openMade(std::move(document), title, std::move(opened))
               : opened ? opened(nullptr)
                        : void();
    mayClose(
        [this, document = std::move(document), title, opened = std::move(opened)](bool mayReplace) {
            const bool shown = mayReplace && show({document, {}}, {}, title);
            if (opened)
                opened(shown ? &session_ : nullptr);
        });
}

void Files::open()
{
    background_.whenIdle([this] {
        if (const QString path = questions_->fileToOpen(folder()); !path.isEmpty())
            open(path);
    });
}

void Files::open(const QString& path)
{
    const QString absolute = QFileInfo(path).absoluteFilePath();
    if (Files* there = placeFor(absolute); there != this)
        return there ? there->open(path) : void();
    opening_ = absolute;
    background_.inTurn([this, absolute](const Turn& turn) {
        keepChanges(turn, [this, absolute](bool mayReplace, const Turn& now) {
            mayReplace ? read(absolute, now) : opening_.clear();
        });
    });
}

void Files::read(const QString& path, const Turn& turn)
{
    background_.run(
        Text::tr("Opening %1…").arg(QFileInfo(path).fileName()),
        [path](const app::Follower&) { return app::openFile(path); },
        [this, path, turn](std::optional<app::OpenedFile> read) {
            opening_.clear();
            if (!read)
                return emit notOpened({});
            if (!read->drawing) {
                const Message why{Message::Kind::Warning,
                                  Text::tr("%1 Nothing was changed.").arg(read->drawing.error)};
                emit told(why);
                return emit notOpened(why);
            }
            if (!show(std::move(*read->drawing.value), path, {}, std::move(read->blocks)))
                return;
            noteRecent();
            tellLosses();
        },
        InBackground::Cancel::Drops);
}

void Files::tellLosses()
{
    const auto& losses = session_.losses();
    if (losses.empty())
        return;
    const QString sentence = app::saveAsReason(losses);
    emit told({Message::Kind::Warning,
               sentence.isEmpty() ? app::changesSentence(name(), losses) : sentence,
               Text::tr("Show details"), [this] {
                   showLosses();
                   tellLosses(); // until it is closed
               }});
}

void Files::showLosses() { questions_->showLosses(name(), session_.losses()); }

void Files::openSample(const app::Sample& sample)
{
    if (Files* there = placeFor(); there != this)
        return there ? there->openSample(sample) : void();
    replace([this, sample](const Turn&) {
        auto read = app::readFile(sample.file);
        if (!read)
            return emit told({Message::Kind::Warning, read.error});
        if (!show(std::move(*read.value), {}, sample.title))
            return;
        sample_ = sample.key;
        emit nameChanged();
    });
}

} // namespace ui
