// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include <functional>

#include "tests/content_of.h"

/// How a program ended.
struct Ended {
    int code;
    QByteArray out, err;
};

/// Runs a program to its end, after `before` in its process. A crash has the code -1.
inline Ended runProgram(const QString& program, const QStringList& arguments,
                        const QByteArray& input = {}, const std::function<void()>& before = {})
{
    QProcess process;
    process.setChildProcessModifier(before);
    auto environment = QProcessEnvironment::systemEnvironment();
    for (const auto* display : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        environment.remove(QString::fromLatin1(display));
    process.setProcessEnvironment(environment);
    process.start(program, arguments);
    process.write(input);
    process.closeWriteChannel();
    process.waitForFinished(120'000);
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
            process.readAllStandardOutput(), process.readAllStandardError()};
}

/// Runs the program that people run, without a display.
inline Ended clearcut(const QStringList& arguments, const QByteArray& input = {})
{
    return runProgram(QStringLiteral(CLEARCUT_BINARY), arguments, input);
}

/// The same after `before` in its process: limits, streams.
inline Ended clearcutAfter(const std::function<void()>& before, const QStringList& arguments)
{
    return runProgram(QStringLiteral(CLEARCUT_BINARY), arguments, {}, before);
}

/// Runs it in a shell, for redirections; $clearcut is the program.
inline Ended inShell(const QString& script)
{
    return runProgram(QStringLiteral("/bin/bash"),
                      {"-c", QStringLiteral("clearcut='" CLEARCUT_BINARY "'; ") + script});
}

inline void writeText(const QString& path, const QByteArray& text)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
        qFatal("cannot write %s", qPrintable(path));
}
