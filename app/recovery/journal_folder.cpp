// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/journal_folder.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <atomic>
#include <functional>
#include <limits>

namespace app {
namespace {

constexpr auto mine = QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner;
const QString basePrefix = QStringLiteral("base-"), logPrefix = QStringLiteral("log-");

std::vector<int> generations(const QString& folder)
{
    std::vector<int> all;
    for (const QString& name : QDir(folder).entryList({basePrefix + u'*'}, QDir::Files))
        if (const int number = name.mid(basePrefix.size()).toInt(); number > 0)
            all.push_back(number);
    std::ranges::sort(all, std::greater());
    return all;
}

constexpr qint64 mostHeader = 1 << 20; // bytes; long enough for any path

std::string contents(const QString& path, qint64 most = std::numeric_limits<qint64>::max())
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    std::string bytes(std::size_t(std::min(most, file.size())), '\0');
    bytes.resize(std::size_t(std::max<qint64>(0, file.read(bytes.data(), qint64(bytes.size())))));
    return bytes;
}

// Calls follow(record) for each record from number `next` on, in this log and the following ones,
// until one is missing or follow() returns false.
void forEachRecord(const QString& folder, int generation, std::uint64_t next,
                   const std::function<bool(std::string_view)>& follow)
{
    for (;; ++generation) {
        const std::string bytes = contents(logFile(folder, generation));
        auto frames = openedLog(bytes);
        if (!frames || frames->number() != next)
            return;
        while (const auto record = frames->next())
            if (!follow(*record))
                return;
        next = frames->number();
    }
}

std::shared_ptr<QLockFile> locked(const QString& folder)
{
    auto lock = std::make_shared<QLockFile>(QDir(folder).filePath(QStringLiteral("lock")));
    lock->setStaleLockTime(0);
    return lock->tryLock() ? lock : nullptr;
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
    return path.endsWith(QStringLiteral(".journal")) && QFileInfo(path).isDir();
}

QString baseFile(const QString& folder, int generation)
{
    return QDir(folder).filePath(basePrefix + QString::number(generation));
}

QString logFile(const QString& folder, int generation)
{
    return QDir(folder).filePath(logPrefix + QString::number(generation));
}

void removeOlder(const QString& folder, int generation)
{
    for (const QString& prefix : {basePrefix, logPrefix})
        for (const QString& name : QDir(folder).entryList({prefix + u'*'}, QDir::Files))
            if (const int number = name.mid(prefix.size()).toInt();
                number > 0 && number < generation)
                QFile::remove(QDir(folder).filePath(name));
}

std::shared_ptr<QLockFile> createJournalFolder(const QString& folder)
{
    const QDir above = QFileInfo(folder).dir();
    QDir().mkpath(QFileInfo(above.path()).path());
    QDir().mkdir(above.path(), mine);
    QFile::setPermissions(above.path(), mine); // it may have been copied or unpacked
    return QDir().mkdir(folder, mine) ? locked(folder) : nullptr;
}

std::shared_ptr<QLockFile> lockJournal(const QString& folder)
{
    return isJournal(folder) ? locked(folder) : nullptr;
}

bool hasBase(const QString& folder) { return !generations(folder).empty(); }

std::optional<JournalState> journalState(const QString& folder)
{
    for (const int generation : generations(folder)) {
        const std::string bytes = contents(baseFile(folder, generation), mostHeader);
        auto header = readBaseHeader(bytes);
        if (!header)
            continue;
        forEachRecord(folder, generation, header->firstRecord,
                      [&](std::string_view record) { return header->state.follow(record); });
        return header->state;
    }
    return std::nullopt;
}

std::optional<Recovered> replayed(const QString& folder)
{
    for (const int generation : generations(folder)) {
        auto base = readBase(contents(baseFile(folder, generation)));
        if (!base)
            continue;
        const std::uint64_t next = base->firstRecord;
        Replay replay(std::move(*base));
        forEachRecord(folder, generation, next,
                      [&](std::string_view record) { return replay.follow(record); });
        return replay.take();
    }
    return std::nullopt;
}

QDateTime lastWritten(const QString& folder)
{
    QDateTime last;
    for (const QFileInfo& file : QDir(folder).entryInfoList({logPrefix + u'*'}, QDir::Files))
        last = std::max(last, file.lastModified());
    return last;
}

} // namespace app
