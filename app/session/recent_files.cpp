// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/recent_files.h"

#include "app/base/text.h"
#include "app/settings/remembered.h"

#include <QFileInfo>
#include <QLocale>
#include <QStringList>

#include <algorithm>

namespace app {

namespace {

const QString recentFilesKey = QStringLiteral("recent");

/// One text for each file, so that the settings file stays readable for people.
QString written(const RecentFile& file)
{
    return QStringLiteral("%1 %2 %3")
        .arg(file.when.toUTC().toString(Qt::ISODate))
        .arg(file.lines)
        .arg(file.path);
}

std::optional<RecentFile> read(const QString& text)
{
    const QString path = text.section(u' ', 2);
    if (!isUsablePath(path))
        return std::nullopt;
    return RecentFile{path, std::size_t(text.section(u' ', 1, 1).toULongLong()),
                      QDateTime::fromString(text.section(u' ', 0, 0), Qt::ISODate)};
}

} // namespace

bool RecentFile::missing() const { return !QFileInfo::exists(path); }

std::vector<RecentFile> recentFiles(const QSettings& settings)
{
    std::vector<RecentFile> files;
    for (const QString& text : settings.value(recentFilesKey).toStringList())
        if (auto file = read(text); file && files.size() < mostRecentFiles)
            files.push_back(*file);
    return files;
}

void remember(QSettings& settings, const RecentFile& file)
{
    auto files = recentFiles(settings);
    std::erase_if(files, [&](const RecentFile& other) { return other.path == file.path; });
    files.insert(files.begin(), file);
    files.resize(std::min(files.size(), mostRecentFiles));
    QStringList texts;
    for (const RecentFile& each : files)
        texts << written(each);
    settings.setValue(recentFilesKey, texts);
}

void forgetRecentFiles(QSettings& settings) { settings.remove(recentFilesKey); }

QString dayText(const QDate& day, const QDate& today)
{
    if (day == today)
        return Text::tr("today");
    if (day.addDays(1) == today)
        return Text::tr("yesterday");
    const bool thisYear = day.year() == today.year();
    return QLocale().toString(day,
                              thisYear ? QStringLiteral("d MMM") : QStringLiteral("d MMM yyyy"));
}

} // namespace app
