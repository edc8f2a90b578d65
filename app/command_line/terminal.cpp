// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/terminal.h"

#include "app/command_line/command.h"
#include "app/command_line/refusal.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace app {
namespace {

// What the answer to a signal may look at: no more than plain memory.
std::array<char, 4096> unfinished;               // how the path of the half file begins
volatile std::sig_atomic_t unfinishedLength = 0; // 0: there is none
constexpr int mostFiles = 100;                   // that are open; we open three

// Only with functions that a signal may interrupt and call. Where there is no /proc it does
// nothing.
void removeUnfinished()
{
    char link[] = "/proc/self/fd/00";
    std::array<char, unfinished.size() + 16> path;
    for (int file = 0; unfinishedLength > 0 && file < mostFiles; ++file) {
        char* const digits = link + sizeof link - 3;
        digits[0] = file < 10 ? char('0' + file) : char('0' + file / 10);
        digits[1] = file < 10 ? '\0' : char('0' + file % 10);
        const auto length = ::readlink(link, path.data(), path.size() - 1);
        if (length <= unfinishedLength
            || std::memcmp(path.data(), unfinished.data(), std::size_t(unfinishedLength)) != 0)
            continue;
        path[std::size_t(length)] = '\0';
        ::unlink(path.data());
    }
}

} // namespace

void print(const QString& text)
{
    printWith([bytes = text.toUtf8()](QIODevice& out) -> std::optional<QString> {
        out.write(bytes);
        return std::nullopt;
    });
}

void printWith(const Filling& write)
{
    QFile out;
    const bool open = out.open(STDOUT_FILENO, QIODevice::WriteOnly);
    if (const auto error = open ? fill(out, write) : out.errorString() + u'.')
        throw Failure{Commands::tr("Cannot write standard output: %1").arg(*error)};
}

void say(const QString& line) { std::fputs((line + u'\n').toUtf8().constData(), stderr); }

// Opened the wrong way round, so that reading or writing is an error as it was. open() takes the
// lowest number that is free; standard error is not missed.
void holdStandardStreams()
{
    struct Stream {
        int number, mode;
    };
    for (const Stream stream : {Stream{STDIN_FILENO, O_WRONLY}, Stream{STDOUT_FILENO, O_RDONLY},
                                Stream{STDERR_FILENO, O_WRONLY}})
        if (::fcntl(stream.number, F_GETFD) < 0 && errno == EBADF) [[maybe_unused]]
            const int taken = ::open("/dev/null", stream.mode);
}

void answerSignals()
{
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGINT, [](int) {
        removeUnfinished();
        ::_exit(int(Exit::Interrupted));
    });
}

// Where the file system has no unnamed files, QSaveFile writes PATH.XXXXXX and renames it at the
// end; a link to a file is followed.
Unfinished::Unfinished(const QString& path)
{
    const QFileInfo info(path), target(info.isSymLink() ? info.symLinkTarget() : path);
    const QByteArray begin =
        QFile::encodeName(target.dir().canonicalPath() + u'/' + target.fileName() + u'.');
    if (std::size_t(begin.size()) > unfinished.size())
        return;
    std::ranges::copy(begin, unfinished.begin());
    unfinishedLength = int(begin.size());
}

Unfinished::~Unfinished() { unfinishedLength = 0; }

} // namespace app
