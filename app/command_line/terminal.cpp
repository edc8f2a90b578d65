// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/terminal.h"

#include "app/base/text.h"
#include "app/base/unfinished.h"
#include "app/command_line/command.h"

#include <QFile>

#include <atomic>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <string_view>
#include <unistd.h>

namespace app {
void print(const QString& text)
{
    printWith([bytes = text.toUtf8()](QIODevice& out) -> std::optional<QString> {
        out.write(bytes);
        return std::nullopt;
    });
}

static void printInto(const Filling& write, QIODevice::OpenMode mode)
{
    QFile out;
    const bool open = out.open(STDOUT_FILENO, mode);
    if (const auto error = open ? fill(out, write) : out.errorString() + u'.')
        throw Failure{Text::tr("Cannot write standard output: %1").arg(*error)};
}

void printWith(const Filling& write) { printInto(write, QIODevice::WriteOnly); }

void printAtOnce(const Filling& write)
{
    printInto(write, QIODevice::WriteOnly | QIODevice::Unbuffered);
}

void say(const QString& line) { std::fputs((line + u'\n').toUtf8().constData(), stderr); }

// The substitute for standard input can only be written and that for standard output only be read,
// so that using them remains an error. Output to a closed standard error is discarded. open()
// returns the lowest free number, so each substitute gets the number of the closed stream.
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

void refuseLongFiles() { std::signal(SIGXFSZ, SIG_IGN); }

void answerSignals()
{
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGINT, [](int) {
        ProgressLine::erase();
        removeUnfinished();
        ::_exit(int(Exit::Interrupted));
    });
}

namespace {

using namespace std::string_view_literals;

constexpr auto empty = "\r\x1b[K"sv; // to the line's start, and erase it
constexpr qint64 patience = 500;     // milliseconds

std::atomic<bool> isShown = false; // a signal handler reads it
static_assert(decltype(isShown)::is_always_lock_free);

} // namespace

Follower ProgressLine::follower()
{
    return {{}, [this](const Progress& progress) { show(progress); }};
}

void ProgressLine::erase()
{
    if (isShown.exchange(false)) [[maybe_unused]]
        const auto written = ::write(STDERR_FILENO, empty.data(), empty.size());
}

void ProgressLine::show(const Progress& progress)
{
    const int percent = int(100 * progress.share);
    if (percent == shown_ || clock_.elapsed() < patience || ::isatty(STDERR_FILENO) == 0)
        return;
    shown_ = percent;
    const QString text =
        Text::tr("%1 %, %2 s left").arg(percent).arg(qint64(std::ceil(progress.secondsLeft)));
    isShown = true;
    std::fputs((QLatin1StringView(empty) + text).toUtf8().constData(), stderr);
}

} // namespace app
