// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/journal_folder.h"

#include "app/recovery/log_file.h"
#include "app/recovery/owner_lock.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <atomic>

namespace app {
namespace {

constexpr auto mine = QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner;
const QString basePrefix = QStringLiteral("base-"), copyPrefix = QStringLiteral("copy-"),
              logPrefix = QStringLiteral("log-");

QString fileOf(const QString& folder, const QString& prefix, int generation)
{
    return QDir(folder).filePath(prefix + QString::number(generation));
}

std::vector<int> generations(const QString& folder, const QString& prefix)
{
    std::vector<int> all;
    for (const QString& name : QDir(folder).entryList({prefix + u'*'}, QDir::Files))
        if (const int number = name.mid(prefix.size()).toInt(); number > 0)
            all.push_back(number);
    std::ranges::sort(all);
    return all;
}

void removeBefore(const QString& folder, const QString& prefix, int generation)
{
    for (const int number : generations(folder, prefix))
        if (number < generation)
            QFile::remove(fileOf(folder, prefix, number));
}

// The newest base before that generation; that generation if there is none.
int previousBase(const QString& folder, int generation)
{
    int previous = generation;
    for (const int number : generations(folder, basePrefix))
        if (number < generation)
            previous = number;
    return previous;
}

QString lockOf(const QString& folder) { return QDir(folder).filePath(QStringLiteral("lock")); }

} // namespace

QString newJournalFolder(const QString& above)
{
    static std::atomic<int> count = 0;
    return QDir(above).filePath(
        QStringLiteral("%1-%2-%3.journal")
            .arg(QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss-zzz")))
            .arg(QCoreApplication::applicationPid())
            .arg(++count));
}

bool isJournal(const QString& path)
{
    return path.endsWith(QStringLiteral(".journal")) && QFileInfo(path).isDir();
}

QString baseFile(const QString& folder, int generation)
{
    return fileOf(folder, basePrefix, generation);
}

QString copyFile(const QString& folder, int generation)
{
    return fileOf(folder, copyPrefix, generation);
}

QString logFile(const QString& folder, int generation)
{
    return fileOf(folder, logPrefix, generation);
}

std::vector<BaseFile> baseFiles(const QString& folder)
{
    std::vector<BaseFile> all;
    for (const QString& prefix : {basePrefix, copyPrefix})
        for (const int generation : generations(folder, prefix))
            all.push_back({generation, fileOf(folder, prefix, generation)});
    std::ranges::stable_sort(all, std::greater(), &BaseFile::generation);
    return all;
}

std::vector<int> logGenerations(const QString& folder) { return generations(folder, logPrefix); }

std::optional<QString> putBase(const QString& folder, int generation, std::string_view bytes,
                               bool continues)
{
    const int previous = previousBase(folder, generation);
    const QString path = baseFile(folder, generation);
    auto wrong = writeWhole(path, bytes);
    if (wrong) { // gives up the second way to the older base, in case the disk is full
        for (const QString& prefix : {basePrefix, logPrefix})
            removeBefore(folder, prefix, previous);
        wrong = writeWhole(path, bytes);
    }
    if (wrong)
        return wrong;
    const int oldest = !continues && putCopy(folder, generation, bytes) ? generation : previous;
    for (const QString& prefix : {basePrefix, logPrefix})
        removeBefore(folder, prefix, oldest);
    removeBefore(folder, copyPrefix, generation);
    return std::nullopt;
}

bool putCopy(const QString& folder, int generation, std::string_view bytes)
{
    return !writeWhole(copyFile(folder, generation), bytes);
}

std::shared_ptr<QLockFile> createJournalFolder(const QString& folder)
{
    const QDir above = QFileInfo(folder).dir();
    QDir().mkpath(QFileInfo(above.path()).path());
    QDir().mkdir(above.path(), mine);
    QFile::setPermissions(above.path(), mine); // it may have been copied or unpacked
    return QDir().mkdir(folder, mine) ? newLock(lockOf(folder)) : nullptr;
}

// Its owner wrote no base before it held the lock.
std::shared_ptr<QLockFile> lockJournal(const QString& folder)
{
    if (!isJournal(folder))
        return nullptr;
    const QString lock = lockOf(folder);
    return baseFiles(folder).empty() ? newLock(lock) : oldLock(lock);
}

} // namespace app
