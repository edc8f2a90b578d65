// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/log_file.h"

#include "app/base/replace_file.h"
#include "app/base/write_all.h"
#include "app/recovery/journal_base.h"
#include "app/recovery/journal_folder.h"

#include <QFile>
#include <QFileInfo>
#include <QtGlobal>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <vector>

#if defined(Q_OS_UNIX)
#include <fcntl.h>
#include <sys/uio.h>
#include <unistd.h>
#endif

namespace app {

#if defined(Q_OS_UNIX)

namespace {

constexpr int onlyUser = 0600;

QString reason() { return qt_error_string(errno); }

// Some file systems cannot sync; there, bytes count as synced when they are written.
bool isSynced(int result)
{
    return result == 0 || errno == EINVAL || errno == ENOSYS || errno == ENOTSUP;
}

// Drops what has been written.
void drop(std::vector<iovec>& parts, std::size_t& first, std::size_t written)
{
    for (; first < parts.size() && written >= parts[first].iov_len; ++first)
        written -= parts[first].iov_len;
    if (written > 0) {
        parts[first].iov_base = static_cast<char*>(parts[first].iov_base) + written;
        parts[first].iov_len -= written;
    }
}

bool writeAt(int file, std::span<const std::string_view> bytes)
{
    std::vector<iovec> parts;
    for (const std::string_view part : bytes)
        if (!part.empty())
            parts.push_back({const_cast<char*>(part.data()), part.size()}); // only read
    for (std::size_t first = 0; first < parts.size();) {
        const int count = int(std::min<std::size_t>(parts.size() - first, IOV_MAX));
        const ssize_t written = ::writev(file, parts.data() + first, count);
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            return false;
        drop(parts, first, std::size_t(written));
    }
    return true;
}

} // namespace

std::shared_ptr<LogFile> LogFile::create(const QString& path, std::string_view bytes,
                                         QString& error)
{
    const QByteArray name = QFile::encodeName(path);
    const int file =
        ::open(name.constData(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, onlyUser);
    if (file < 0) {
        error = reason();
        return nullptr;
    }
    std::shared_ptr<LogFile> log(new LogFile(file, path));
    if (const auto wrong = log->append(bytes)) {
        error = *wrong;
        ::unlink(name.constData());
        return nullptr;
    }
    return log;
}

LogFile::~LogFile() { ::close(file_); }

std::optional<QString> LogFile::append(std::span<const std::string_view> parts)
{
    if (!writeAt(file_, parts)) {
        const QString why = reason();
        [[maybe_unused]] const int cut = ::ftruncate(file_, off_t(size_)); // a torn end is ignored
        return why;
    }
    for (const std::string_view part : parts)
        size_ += part.size();
    return std::nullopt;
}

std::optional<QString> LogFile::sync()
{
    if (!isSynced(::fdatasync(file_)))
        return reason();
    if (!named_)
        if (auto wrong = syncNames())
            return wrong;
    named_ = true;
    return std::nullopt;
}

std::optional<QString> LogFile::syncNames() const
{
    const QString folder = QFileInfo(path_).path();
    for (const QString& each : {folder, QFileInfo(folder).path()}) {
        const int open =
            ::open(QFile::encodeName(each).constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        const bool synced = open >= 0 && isSynced(::fsync(open));
        const QString why = reason();
        if (open >= 0)
            ::close(open);
        if (!synced)
            return why;
    }
    return std::nullopt;
}

#else

std::shared_ptr<LogFile> LogFile::create(const QString&, std::string_view, QString& error)
{
    error = QStringLiteral("not supported");
    return nullptr;
}
LogFile::~LogFile() = default;
std::optional<QString> LogFile::append(std::span<const std::string_view>) { return QString(); }
std::optional<QString> LogFile::sync() { return QString(); }
std::optional<QString> LogFile::syncNames() const { return QString(); }

#endif

std::optional<QString> writeWhole(const QString& path, std::string_view bytes)
{
    const auto error = replaceFile(path, [&](QIODevice& out) -> std::optional<QString> {
        return writeAll(out, bytes) ? std::nullopt : std::optional(out.errorString());
    });
    if (!error)
        QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner);
    return error;
}

std::string contentsOf(const QString& path, qint64 most)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    std::string bytes(std::size_t(std::min(most, file.size())), '\0');
    bytes.resize(std::size_t(std::max<qint64>(0, file.read(bytes.data(), qint64(bytes.size())))));
    return bytes;
}

Reach forEachRecord(const QString& folder, int generation, std::uint64_t next,
                    const std::function<bool(std::string_view)>& follow)
{
    Reach reach{next, true};
    for (; QFile::exists(logFile(folder, generation)); ++generation) {
        const std::string bytes = contentsOf(logFile(folder, generation));
        FrameReader frames = recordsOf(bytes, reach.end);
        while (const auto record = frames.next()) {
            if (!follow(*record))
                return {reach.end, false};
            reach.end = frames.number();
        }
        reach.whole = reach.whole && frames.atEnd();
    }
    return reach;
}

} // namespace app
