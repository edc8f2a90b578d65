// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/replace_file.h"

#include "app/base/text.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace app {
namespace {

// The device that `write` fills. It takes each write as a whole or fails, and remembers its first
// failure: a full disk accepts a part of a write without an error, and some writers ignore errors
// (QPdfWriter).
class Sink final : public QIODevice {
public:
    explicit Sink(QFileDevice& file) : file_(file) { open(WriteOnly | Unbuffered); }

    bool isSequential() const override { return true; }

    // QFileDevice::flush writes only one of several blocks, and perhaps only a part of it.
    bool flush()
    {
        while (!failed_ && file_.bytesToWrite() > 0) {
            const qint64 before = file_.bytesToWrite();
            errno = 0;
            if (!file_.flush() && file_.bytesToWrite() == before)
                fail();
        }
        return !failed_;
    }

    bool failed() const { return failed_; }
    bool readerGone() const { return readerGone_; }

protected:
    qint64 readData(char*, qint64) override { return -1; }

    qint64 writeData(const char* bytes, qint64 size) override
    {
        for (qint64 done = 0; !failed_ && done < size;) {
            errno = 0;
            const qint64 written = file_.write(bytes + done, size - done);
            if (written > 0)
                done += written;
            else if (file_.bytesToWrite() == 0 || !flush())
                fail();
        }
        return failed_ ? -1 : size;
    }

private:
    void fail()
    {
        if (std::exchange(failed_, true))
            return;
        readerGone_ = errno == EPIPE;
        setErrorString(file_.errorString());
    }

    QFileDevice& file_;
    bool failed_ = false, readerGone_ = false;
};

QString sentence(int error) { return qt_error_string(error) + u'.'; }

// Some file systems do not support fsync; their files count as written.
bool reachedDisk(int file)
{
    return ::fsync(file) == 0 || errno == EINVAL || errno == ENOSYS || errno == ENOTSUP;
}

// Writes the new name to the disk by syncing its folder. Errors are ignored: the new file is in
// place in any case.
void syncFolderOf(const QString& path)
{
    const QByteArray folder = QFile::encodeName(QFileInfo(path).canonicalPath());
    if (const int open = ::open(folder.constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        open >= 0) {
        ::fsync(open);
        ::close(open);
    }
}

bool isLinkToItself(const QString& path)
{
    struct stat found {};
    return ::stat(QFile::encodeName(path).constData(), &found) != 0 && errno == ELOOP;
}

} // namespace

std::optional<QString> fill(QFileDevice& file, const Filling& write)
{
    Sink sink(file);
    auto error = write(sink);
    if (sink.readerGone())
        return std::nullopt;
    if (error && !sink.failed())
        return error;
    if (sink.flush() || sink.readerGone())
        return std::nullopt;
    return sink.errorString() + u'.';
}

std::optional<QString> fillToDisk(QFileDevice& file, const Filling& write)
{
    if (auto error = fill(file, write))
        return error;
    return reachedDisk(file.handle()) ? std::nullopt : std::optional(sentence(errno));
}

std::optional<QString> replaceFile(const QString& path, const Filling& write)
{
    if (auto fault = faultOfName(path))
        return fault;
    if (isLinkToItself(path))
        return Text::tr("it is a link that leads to itself. Remove it, or give another name.");
    const QFileInfo info(path);
    if (info.exists() && !info.isFile() && !info.isDir()) { // never replace a device by a file
        QFile device(path);
        if (!device.open(QIODevice::WriteOnly))
            return device.errorString() + u'.';
        return fill(device, write);
    }
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return file.errorString() + u'.';
    // QSaveFile::commit ignores errors of its last flush and of fsync (Qt 6.4).
    if (auto error = fillToDisk(file, write))
        return error;
    if (!file.commit())
        return file.errorString() + u'.';
    syncFolderOf(path);
    return std::nullopt;
}

std::optional<QString> faultOfName(const QString& path)
{
    // Qt replaces each byte that is not UTF-8 by U+FFFD; but a file may really have that in its
    // name.
    if (!path.contains(QChar::ReplacementCharacter) || QFileInfo::exists(path))
        return std::nullopt;
    return Text::tr("its name is not UTF-8. Give it another name.");
}

} // namespace app
