// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/files.h"

#include "ui/look/text.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

namespace ui {

Files::Files(app::Session& session, QWidget& window, std::unique_ptr<Questions> questions)
    : session_(session), questions_(std::move(questions)), background_(&window)
{
    connect(&session, &app::Session::fileChanged, this, &Files::nameChanged);
    connect(&session, &app::Session::loaded, this, [this] { exported_.reset(); });
    connect(&session.history, &app::History::indexChanged, this,
            [this] { questions_->endSaveChanges(Questions::Answer::Cancel); });
    connect(&background_, &InBackground::ranOutOfMemory, this, [this] {
        emit told(
            {Message::Kind::Warning,
             Text::tr(
                 "There is not enough memory for this. Close other programs, and try again.")});
    });
    watchFile();
}

void Files::setQuestions(std::unique_ptr<Questions> questions)
{
    questions_ = std::move(questions);
}

void Files::setOthers(Place place, Held held)
{
    place_ = std::move(place);
    held_ = std::move(held);
}

bool Files::areSame(const QString& a, const QString& b)
{
    const QFileInfo first(a), second(b);
    return !a.isEmpty()
           && (first.absoluteFilePath() == second.absoluteFilePath()
               || (first.exists() && first.canonicalFilePath() == second.canonicalFilePath()));
}

bool Files::holds(const QString& path) const
{
    return areSame(session_.path(), path) || areSame(opening_, path);
}

QString Files::refusalToWrite(const QString& path) const
{
    if (!holds(path) && !(held_ && held_(path)))
        return {};
    return Text::tr("%1 is an open drawing, which must not be replaced. Choose another name.")
        .arg(QFileInfo(path).fileName());
}

QString Files::name() const
{
    if (!session_.path().isEmpty())
        return QFileInfo(session_.path()).fileName();
    return number_ == 1 ? title() : Text::tr("%1 %2").arg(title()).arg(number_);
}

QString Files::title() const { return title_.isEmpty() ? Text::tr("Untitled") : title_; }

void Files::setNumber(int number)
{
    if (number == number_)
        return;
    number_ = number;
    emit nameChanged();
}

QString Files::folder() const
{
    if (!session_.path().isEmpty())
        return QFileInfo(session_.path()).absolutePath();
    const auto files = recent();
    return files.empty() ? QDir::homePath() : QFileInfo(files.front().path).absolutePath();
}

QString Files::baseName() const
{
    return session_.path().isEmpty() ? name() : QFileInfo(name()).completeBaseName();
}

/// A path for a new file, beside the drawing's.
QString Files::proposal(const QString& ending) const
{
    return QDir(folder()).filePath(baseName() + ending);
}

app::Origin Files::origin() const
{
    return {name(), session_.mustSaveAs() ? QString() : session_.path(), seen_};
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

#include "moc_files.cpp"
