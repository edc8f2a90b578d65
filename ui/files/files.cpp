// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/files.h"

#include "app/commands/crop_to_window.h"
#include "app/comparison/cut_text.h"
#include "app/document/flattened.h"
#include "app/document/hidden_objects.h"
#include "app/formats/loss_text.h"
#include "ui/dialogs/in_background.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

namespace ui {

namespace {

constexpr double exportDpi = 300;         // of exported pictures
constexpr double newPenMillimetres = 0.3; // the stroke width in a new drawing

bool isNative(const QString& path) { return app::formatOfFile(path) == &app::formats().front(); }

app::Document emptyDocument()
{
    app::Document document;
    document.apply(
        {.page = app::Page{{0, 0}, {420, 297}, {420, app::Unit::Mm}, {297, app::Unit::Mm}}});
    return document;
}

} // namespace

Files::Files(app::Session& session, QWidget& window, std::unique_ptr<Questions> questions)
    : session_(session), window_(window), questions_(std::move(questions))
{
    connect(&session, &app::Session::fileChanged, this, &Files::nameChanged);
}

void Files::setQuestions(std::unique_ptr<Questions> questions)
{
    questions_ = std::move(questions);
}

QString Files::name() const
{
    if (!session_.path().isEmpty())
        return QFileInfo(session_.path()).fileName();
    return title_.isEmpty() ? tr("Untitled") : title_;
}

QString Files::folder() const
{
    if (!session_.path().isEmpty())
        return QFileInfo(session_.path()).absolutePath();
    const auto files = recent();
    return files.empty() ? QDir::homePath() : QFileInfo(files.front().path).absolutePath();
}

void Files::show(app::Imported imported, const QString& path, const QString& title)
{
    title_ = title;
    sample_.clear();
    session_.load(std::move(imported), path);
    session_.pen.style.width = newPenMillimetres / session_.now().page().millimetresPerUnit();
    seen_ = QFileInfo(path).lastModified();
    emit nameChanged();
    emit told({});
}

void Files::startNew()
{
    if (mayClose())
        show({emptyDocument(), {}}, {}, {});
}

bool Files::openMade(app::Document document, const QString& title)
{
    if (!mayClose())
        return false;
    show({std::move(document), {}}, {}, title);
    return true;
}

void Files::open()
{
    if (const QString path = questions_->fileToOpen(folder()); !path.isEmpty())
        open(path);
}

void Files::open(const QString& path)
{
    if (!mayClose())
        return;
    const QString absolute = QFileInfo(path).absoluteFilePath();
    auto read = inBackground(&window_, tr("Opening %1…").arg(QFileInfo(path).fileName()),
                             [absolute] { return app::readFile(absolute); });
    if (!read)
        return;
    if (!*read) {
        emit told({Message::Kind::Warning, tr("%1 Nothing was changed.").arg(read->error)});
        return;
    }
    show(std::move(*read->value), absolute, {});
    noteRecent();
    if (const auto& losses = session_.losses(); !losses.empty()) {
        const QString sentence = app::lossSentence(losses);
        emit told(
            {Message::Kind::Warning,
             sentence.isEmpty() ? tr("%1 was opened with some changes.").arg(name()) : sentence,
             tr("Show details"), [this, losses] { questions_->showLosses(name(), losses); }});
    }
}

void Files::openSample(const app::Sample& sample)
{
    if (!mayClose())
        return;
    auto read = app::readFile(sample.file);
    if (!read) {
        emit told({Message::Kind::Warning, read.error});
        return;
    }
    show(std::move(*read.value), {}, sample.title);
    sample_ = sample.key;
    emit nameChanged();
}

bool Files::save()
{
    emit documentWanted();
    const QString path = session_.path();
    if (path.isEmpty() || !isNative(path))
        return saveAs();
    if (session_.mustSaveAs())
        return questions_->saveAsNewFile(session_.losses()) && saveAs();
    const bool changedElsewhere =
        QFileInfo::exists(path) && QFileInfo(path).lastModified() != seen_;
    return (!changedElsewhere || questions_->overwriteChanged(path)) && write(path);
}

// Only the native format holds a whole drawing; another format would lose parts of it.
bool Files::saveAs()
{
    emit documentWanted();
    const QString base = session_.path().isEmpty() ? name() : QFileInfo(name()).completeBaseName();
    const QString path = questions_->fileToSave(
        tr("Save as"), QDir(folder()).filePath(base + QStringLiteral(".svg")),
        Questions::Formats::Native);
    if (path.isEmpty() || isNative(path))
        return !path.isEmpty() && write(path);
    emit told({Message::Kind::Warning, tr("%1 was not saved, because drawings are saved only as "
                                          "SVG. “Export cut drawing…” writes other types.")
                                           .arg(QFileInfo(path).fileName())});
    return false;
}

bool Files::write(const QString& path)
{
    if (const auto error = session_.save(path)) {
        emit told({Message::Kind::Warning, *error});
        return false;
    }
    seen_ = QFileInfo(path).lastModified();
    title_.clear();
    sample_.clear();
    noteRecent();
    emit nameChanged();
    emit told({});
    return true;
}

app::CutOptions Files::cutOptions() const
{
    app::CutOptions options{.clipAll = session_.uses().clipAll};
    options.region = app::regionOf(session_.now().windows());
    return options;
}

namespace {

using Exported = std::pair<std::optional<QString>, app::CutCounts>;

// Runs on a thread of its own, where an exception would end the program. Separate lines are cut as
// lines, so that each of them is inside the window.
Exported exported(app::Document document, const app::CutOptions& options, const QString& path,
                  const app::WriteOptions& writing, bool hides)
{
    try {
        // A cut adds many styles; the open document keeps its own.
        document = app::withOwnStyles(document);
        if (!hides)
            document = app::withoutHidden(document);
        if (options.keepContacts)
            document = app::flattened(document, app::usualTolerance(document.page()));
        app::Cut cut = app::cut(document, options);
        cut.edit.windows = app::ClipWindows(); // the exported drawing must not be cut again
        document.apply(cut.edit);
        return {app::writeFile(document, path, writing), cut.counts};
    } catch (const std::bad_alloc&) {
        return {Files::tr("Cannot export %1: there is not enough memory. Close other programs, or "
                          "export a part of the drawing.")
                    .arg(path),
                {}};
    }
}

} // namespace

void Files::exportCut()
{
    emit documentWanted();
    const QString base = session_.path().isEmpty() ? name() : QFileInfo(name()).completeBaseName();
    const QString path = questions_->fileToSave(
        tr("Export cut drawing"), QDir(folder()).filePath(base + QStringLiteral("-cut.svg")),
        Questions::Formats::All);
    if (path.isEmpty())
        return;
    app::CutOptions options = cutOptions();
    const app::Format* format = app::formatOfFile(path);
    options.keepContacts = format && format->holds == app::Holds::SeparateLines;
    app::WriteOptions writing;
    writing.dpi = exportDpi;
    std::stop_source cancel;
    writing.stop = cancel.get_token();
    const bool hides = format && format->hides == app::StoresHidden::Yes;
    const auto job = [document = session_.now(), options, path, writing, hides] {
        return exported(document, options, path, writing, hides);
    };
    const auto done =
        inBackground(&window_, tr("Exporting %1…").arg(QFileInfo(path).fileName()), job);
    if (!done) {
        cancel.request_stop();
        return;
    }
    const auto& [error, counts] = *done;
    if (error)
        emit told({Message::Kind::Warning, *error});
    else
        emit told({Message::Kind::Done,
                   tr("Exported %1: %2").arg(QFileInfo(path).fileName(), app::cutText(counts))});
}

void Files::crop()
{
    emit documentWanted();
    app::CutOptions options = cutOptions();
    options.scope = app::CutScope::Editable;
    auto command = std::make_unique<app::CropToWindow>(session_.document, options);
    const app::CutCounts counts = command->counts();
    if (const QString leftAlone = app::leftAloneText(counts); !command->changes())
        return emit told({Message::Kind::Done,
                          leftAlone.isEmpty()
                              ? tr("Nothing was cropped: the clip window keeps all of the drawing.")
                              : tr("Nothing was cropped.") + leftAlone});
    session_.history.push(command.release());
    emit told({Message::Kind::Done, tr("Cropped: %1").arg(app::cutText(counts))});
}

bool Files::mayClose()
{
    emit documentWanted();
    if (session_.history.isClean() || app::isUnchangedSample(sample_, session_.now()))
        return true;
    switch (questions_->saveChanges(name())) {
    case Questions::Answer::Save:
        return save();
    case Questions::Answer::DontSave:
        return true;
    case Questions::Answer::Cancel:
        break;
    }
    return false;
}

app::Origin Files::origin() const
{
    return {name(), session_.mustSaveAs() ? QString() : session_.path(), seen_};
}

bool Files::recover(app::Leftover& leftover)
{
    auto read = inBackground(
        &window_, tr("Recovering %1…").arg(leftover.origin.name),
        [file = leftover.file] { return app::readFile(file, &app::formats().front()); });
    if (!read)
        return false;
    if (!*read) {
        const QString aside = app::setAside(leftover);
        emit told({Message::Kind::Warning, tr("%1 cannot be recovered: %2 Its file is kept as %3.")
                                               .arg(leftover.origin.name, read->error, aside)});
        return false;
    }
    const app::Origin& origin = leftover.origin;
    show(std::move(*read->value), origin.path, origin.path.isEmpty() ? origin.name : QString());
    seen_ = origin.fileTime;
    session_.history.resetClean(); // mark as unsaved
    emit told({Message::Kind::Done, tr("Recovered %1. Save it to keep it.").arg(origin.name)});
    return true;
}

std::vector<app::RecentFile> Files::recent() const { return app::recentFiles(QSettings()); }

void Files::noteRecent()
{
    QSettings settings;
    app::remember(settings, {QFileInfo(session_.path()).absoluteFilePath(),
                             session_.scene.lines().size(), QDateTime::currentDateTime()});
    emit recentChanged();
}

void Files::forgetRecent()
{
    QSettings settings;
    app::forgetRecentFiles(settings);
    emit recentChanged();
}

} // namespace ui
