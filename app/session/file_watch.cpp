// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/file_watch.h"

#include <QFileInfo>

#include <utility>

namespace app {

FileWatch::FileWatch(QObject* parent) : QObject(parent)
{
    rest_.setSingleShot(true);
    rest_.setInterval(rest);
    connect(&rest_, &QTimer::timeout, this, &FileWatch::look);
    const auto wait = [this] { rest_.start(); };
    connect(&watcher_, &QFileSystemWatcher::fileChanged, this, wait);
    connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, wait);
}

void FileWatch::follow(const QString& path, const QDateTime& known)
{
    pause();
    path_ = path;
    known_ = known;
    if (path.isEmpty())
        return;
    watcher_.addPath(QFileInfo(path).absolutePath());
    watch();
    rest_.start(); // for a change just before
}

void FileWatch::pause()
{
    rest_.stop();
    path_.clear();
    for (const QStringList& watched : {watcher_.files(), watcher_.directories()})
        if (!watched.isEmpty())
            watcher_.removePaths(watched);
}

// A file that replaced another one is a new file for the system.
void FileWatch::watch()
{
    if (QFileInfo::exists(path_) && !watcher_.files().contains(path_))
        watcher_.addPath(path_);
}

void FileWatch::look()
{
    if (path_.isEmpty())
        return;
    watch();
    const QFileInfo file(path_);
    const QDateTime now = file.exists() ? file.lastModified() : QDateTime();
    if (now == std::exchange(known_, now))
        return;
    if (now.isValid())
        emit changed();
    else
        emit removed();
}

} // namespace app

#include "moc_file_watch.cpp"
