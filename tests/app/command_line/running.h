// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "tests/app/command_line/program.h"

/// The two ends of a pipe, which close with it.
struct Pipe {
    int out = -1, in = -1;

    Pipe()
    {
        int ends[2];
        if (::pipe2(ends, O_CLOEXEC) != 0)
            qFatal("no pipe");
        out = ends[0];
        in = ends[1];
    }
    ~Pipe()
    {
        close(out);
        close(in);
    }
    static void close(int& end)
    {
        if (end >= 0)
            ::close(end);
        end = -1;
    }
};

/// What comes from a pipe: `size` bytes, or fewer if it ends or nothing comes for 20 s.
inline QByteArray readFrom(int pipe, qsizetype size)
{
    QByteArray got(size, ' ');
    qsizetype count = 0;
    for (pollfd ready{pipe, POLLIN, 0}; count<size&& ::poll(&ready, 1, 20'000)> 0;) {
        const ssize_t more = ::read(pipe, got.data() + count, std::size_t(size - count));
        if (more <= 0)
            break;
        count += more;
    }
    return got.first(count);
}

/// The most memory that a running program has used, in kilobytes.
inline QByteArray peakKilobytes(const QProcess& process)
{
    const QString status = QStringLiteral("/proc/%1/status").arg(process.processId());
    for (const QByteArray& line : contentOf(status).split('\n'))
        if (line.startsWith("VmHWM:"))
            return line.simplified().split(' ').at(1);
    return {};
}
