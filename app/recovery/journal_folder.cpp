// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/journal_folder.h"

#include "app/recovery/log_file.h"
#include "app/recovery/owner_lock.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>

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

QStringList filesOf(const QString& folder, const QStringList& patterns = {})
{
    return QDir(folder).entryList(patterns, QDir::Files | QDir::Hidden | QDir::NoSymLinks);
}

std::vector<int> generations(const QString& folder, const QString& prefix)
{
    std::vector<int> all;
    for (const QString& name : filesOf(folder, {prefix + u'*'}))
        if (const int number = name.mid(prefix.size()).toInt();
            number > 0 && name == prefix + QString::number(number))
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

// The names that a journal gives, also to temporary files (QSaveFile, QLockFile).
QStringList ownFilesOf(const QString& folder)
{
    static const QRegularExpression own(
        QStringLiteral("^((base|copy|log)-[1-9][0-9]*(\\.[A-Za-z]{6})?|lock(\\.rmlock)?)$"));
    return filesOf(folder).filter(own);
}

bool isForeign(const QString& folder)
{
    const auto everything = QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot;
    return generations(folder, basePrefix).empty() && generations(folder, copyPrefix).empty()
           && generations(folder, logPrefix).empty()
           && QDir(folder).entryList(everything).size() > ownFilesOf(folder).size();
}

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
    const QFileInfo info(path);
    return path.endsWith(QStringLiteral(".journal")) && info.isDir() && !info.isSymLink();
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

void makePrivateFolder(const QString& path)
{
    QDir().mkpath(QFileInfo(path).path());
    if (!QDir().mkdir(path, mine) && !QFileInfo(path).isSymLink())
        QFile::setPermissions(path, mine); // it may have been copied or unpacked
}

std::shared_ptr<QLockFile> createJournalFolder(const QString& folder)
{
    makePrivateFolder(QFileInfo(folder).path());
    return QDir().mkdir(folder, mine) ? newLock(lockOf(folder)) : nullptr;
}

// Its owner wrote no base before it held the lock.
std::shared_ptr<QLockFile> lockJournal(const QString& folder)
{
    if (!isJournal(folder) || isForeign(folder))
        return nullptr;
    const QString lock = lockOf(folder);
    return baseFiles(folder).empty() ? newLock(lock) : oldLock(lock);
}

void removeJournal(const QString& folder)
{
    if (!isJournal(folder))
        return;
    for (const QString& name : ownFilesOf(folder))
        QFile::remove(QDir(folder).filePath(name));
    QDir().rmdir(folder);
}

} // namespace app
