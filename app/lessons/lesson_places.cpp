// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/lesson_places.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

namespace app {

namespace {

constexpr qsizetype mostPlaces = 12, longestPath = 4096;

QString placesKey() { return QStringLiteral("lessons/opened"); }

} // namespace

QStringList lessonPlaces(const QSettings& settings)
{
    QStringList paths = settings.value(placesKey()).toStringList();
    paths.removeIf([](const QString& path) {
        return path.size() > longestPath || !QFileInfo(path).isAbsolute();
    });
    paths.removeDuplicates();
    return paths.last(std::min(paths.size(), mostPlaces));
}

void keepLessonPlaces(QSettings& settings, const QStringList& paths)
{
    QStringList all = lessonPlaces(settings);
    for (const QString& path : paths) {
        const QString whole = QDir::cleanPath(QFileInfo(path).absoluteFilePath());
        all.removeAll(whole);
        all << whole;
    }
    settings.setValue(placesKey(), all.last(std::min(all.size(), mostPlaces)));
}

void forgetLessonPlace(QSettings& settings, const QString& folder)
{
    QStringList all = lessonPlaces(settings);
    all.removeIf([&](const QString& path) {
        // Not a folder in it, which may only be away: on a medium that is not mounted.
        return path == folder
               || (path.endsWith(u".md", Qt::CaseInsensitive) && !QFileInfo(path).isDir()
                   && QFileInfo(path).path() == folder);
    });
    settings.setValue(placesKey(), all);
}

} // namespace app
