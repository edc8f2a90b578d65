// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/leftover.h"

#include "app/base/replace_file.h"
#include "app/base/text.h"
#include "app/base/write_all.h"
#include "app/formats/svg/writer.h"
#include "app/recovery/journal_folder.h"
#include "app/recovery/journal_reading.h"
#include "app/recovery/owner_lock.h"
#include "app/session/samples.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QUrl>

#include <algorithm>
#include <atomic>

namespace app {
namespace {

constexpr qint64 mostTail = 64 << 10; // bytes; long enough for any path

/// "<?clearcut-unsaved name="…" path="…" file-time="…" ended="…"?>", times in milliseconds.
QByteArray instruction(const Origin& origin, const QDateTime& ended)
{
    const auto attribute = [](const char* name, const QString& value) {
        return QByteArray(" ") + name + "=\"" + QUrl::toPercentEncoding(value) + '"';
    };
    const auto time = [](const QDateTime& when) {
        return when.isValid() ? QString::number(when.toMSecsSinceEpoch()) : QString();
    };
    return "<?clearcut-unsaved" + attribute("name", origin.name) + attribute("path", origin.path)
           + attribute("file-time", time(origin.fileTime)) + attribute("ended", time(ended))
           + "?>\n";
}

/// Empty for a file from elsewhere, or an incomplete file.
std::optional<Leftover> described(const QString& file)
{
    QFile in(file);
    if (!in.open(QIODevice::ReadOnly))
        return std::nullopt;
    in.seek(std::max<qint64>(0, in.size() - mostTail));
    static const QRegularExpression pattern(QStringLiteral(
        "<\\?clearcut-unsaved name=\"([^\"]*)\" path=\"([^\"]*)\" file-time=\"(\\d*)\" "
        "ended=\"(\\d+)\"\\?>\\s*$"));
    const auto found = pattern.match(QString::fromLatin1(in.read(mostTail)));
    if (!found.hasMatch())
        return std::nullopt;
    const auto text = [&](int group) {
        return QUrl::fromPercentEncoding(found.captured(group).toLatin1());
    };
    const auto time = [&](int group) {
        return found.captured(group).isEmpty()
                   ? QDateTime()
                   : QDateTime::fromMSecsSinceEpoch(found.captured(group).toLongLong());
    };
    return Leftover{file, {text(1), text(2), time(3)}, time(4), nullptr};
}

bool unchangedSample(const JournalState& state, const QString& journal)
{
    if (state.origin.sample.isEmpty() || state.inHand)
        return false;
    const auto found = replayed(journal);
    return found && isUnchangedSample(state.origin.sample, found->document);
}

/// Claims it by a lock file that names the owning process; the lock of an ended process is taken
/// over.
bool claim(Leftover& leftover)
{
    auto lock = newLock(leftover.file + QStringLiteral(".lock"));
    if (!lock || !QFileInfo::exists(leftover.file))
        return false;
    leftover.claim = std::move(lock);
    return true;
}

/// Whether a journal surely holds no unsaved changes.
bool isOfNoUse(const std::optional<KnownJournal>& found, const QString& journal)
{
    if (!found)
        return !hasContents(journal);
    return !found->damaged && (!found->state.unsaved() || unchangedSample(found->state, journal));
}

/// Removes journals without unsaved changes.
std::vector<Leftover> claimJournals(const QString& folder)
{
    std::vector<Leftover> all;
    for (const QFileInfo& info :
         QDir(folder).entryInfoList({QStringLiteral("*.journal")}, QDir::Dirs | QDir::NoSymLinks))
        if (auto lock = lockJournal(info.filePath())) {
            Leftover leftover{info.filePath(), {}, lastWritten(info.filePath()), std::move(lock)};
            const auto found = known(leftover.file);
            if (isOfNoUse(found, leftover.file)) {
                discard(leftover);
                continue;
            }
            leftover.origin = (found ? found->state.origin : firstOrigin(leftover.file)).origin;
            if (leftover.origin.name.isEmpty())
                leftover.origin.name = info.fileName();
            all.push_back(std::move(leftover));
        }
    return all;
}

} // namespace

QString leftoverFolder()
{
#if defined(Q_OS_LINUX)
    const QString given = qEnvironmentVariable("XDG_STATE_HOME");
    const QString state =
        QDir::isAbsolutePath(given) ? given : QDir::home().filePath(QStringLiteral(".local/state"));
    return QDir(state).filePath(QStringLiteral("clearcut/unsaved"));
#else
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation))
        .filePath(QStringLiteral("unsaved"));
#endif
}

std::optional<QString> writeLeftover(const Document& document, const Origin& origin,
                                     const QString& file)
{
    makePrivateFolder(QFileInfo(file).path());
    const auto error = replaceFile(file, [&](QIODevice& out) -> std::optional<QString> {
        if (auto wrong = svg::write(document, out, {}))
            return wrong;
        const QByteArray end = instruction(origin, QDateTime::currentDateTime());
        return writeAll(out, {end.constData(), std::size_t(end.size())})
                   ? std::nullopt
                   : std::optional(out.errorString());
    });
    QFile::setPermissions(file, QFile::ReadOwner | QFile::WriteOwner);
    return error ? std::optional(Text::tr("Cannot write %1: %2").arg(file, *error)) : std::nullopt;
}

QString newLeftoverFile(const QString& folder)
{
    static std::atomic<int> number = 0; // several drawings of this process
    return QDir(folder).filePath(
        QStringLiteral("%1-%2-%3.svg")
            .arg(QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss-zzz")))
            .arg(QCoreApplication::applicationPid())
            .arg(++number));
}

std::vector<Leftover> claimLeftovers(const QString& folder)
{
    std::vector<Leftover> all = claimJournals(folder);
    for (const QFileInfo& info : QDir(folder).entryInfoList(
             {QStringLiteral("*.svg")}, QDir::Files | QDir::Readable | QDir::NoSymLinks))
        if (auto leftover = described(info.filePath()); leftover && claim(*leftover))
            all.push_back(std::move(*leftover));
    std::ranges::sort(all, std::greater(), &Leftover::ended);
    return all;
}

void discard(Leftover& leftover)
{
    if (isJournal(leftover.file)) {
        if (leftover.claim)
            leftover.claim->unlock(); // the lock is in the folder
        removeJournal(leftover.file);
    } else {
        QFile::remove(leftover.file);
        leftover.claim.reset();
    }
}

QString setAside(Leftover& leftover)
{
    const QString ending = QStringLiteral(".unreadable");
    QString aside = leftover.file + ending;
    for (int i = 2; QFileInfo::exists(aside); ++i)
        aside = leftover.file + u'-' + QString::number(i) + ending;
    if (leftover.claim && isJournal(leftover.file))
        leftover.claim->unlock(); // the lock is in the folder
    QFile::rename(leftover.file, aside);
    leftover.claim.reset();
    return aside;
}

} // namespace app
