// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fcntl.h>
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

/// The most memory that a running program has used, in kilobytes.
inline QByteArray peakKilobytes(const QProcess& process)
{
    const QString status = QStringLiteral("/proc/%1/status").arg(process.processId());
    for (const QByteArray& line : contentOf(status).split('\n'))
        if (line.startsWith("VmHWM:"))
            return line.simplified().split(' ').at(1);
    return {};
}
