// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/export_path.h"

#include "app/base/text.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QLocale>

namespace app {
namespace {

QString endingOf(const Format& format) { return u'.' + latin(format.key); }

/// "14:02" today, else with the day.
QString timeText(const QDateTime& when)
{
    const QLocale locale;
    const QString time = locale.toString(when.time(), QStringLiteral("HH:mm"));
    return when.date() == QDate::currentDate()
               ? time
               : Text::tr("%1, %2").arg(locale.toString(when.date(), QLocale::ShortFormat), time);
}

} // namespace

QString shownPath(const QString& path)
{
    const QString home = QDir::homePath();
    return path.startsWith(home + u'/') ? u'~' + path.mid(home.size()) : path;
}

QString writtenPath(const QString& typed, const Format& format)
{
    QString path = typed.trimmed();
    if (path.isEmpty())
        return {};
    if (path.startsWith(QStringLiteral("~/")))
        path = QDir::homePath() + path.mid(1);
    path = QDir::cleanPath(QDir::home().absoluteFilePath(path));
    return path.endsWith(endingOf(format), Qt::CaseInsensitive) ? path : path + endingOf(format);
}

QString withEnding(const QString& path, const Format& format)
{
    if (path.isEmpty())
        return {};
    const Format* other = formatOfFile(path);
    const QString bare = other ? path.chopped(qsizetype(other->key.size()) + 1) : path;
    return bare + endingOf(format);
}

PathRemark remarkOn(const QString& path)
{
    if (path.isEmpty())
        return {Text::tr("Give the file a name."), true};
    const QFileInfo file(path), folder(file.absolutePath());
    const QString name = file.fileName();
    if (!folder.exists())
        return {Text::tr("There is no folder %1.").arg(shownPath(folder.filePath())), true};
    if (file.isDir())
        return {Text::tr("%1 is a folder.").arg(name), true};
    if (file.exists() && !file.isWritable())
        return {Text::tr("%1 is read-only.").arg(name), true};
    if (!file.exists() && !folder.isWritable())
        return {Text::tr("The folder %1 is read-only.").arg(shownPath(folder.filePath())), true};
    if (file.exists())
        return {Text::tr("Replaces %1 of %2").arg(name, timeText(file.lastModified()))};
    return {};
}

} // namespace app
