// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/app/command_line/program.h"

/// Gives the program a row, waits for its output, then gives it the row "bad" and neither more nor
/// the end of the input. The code is -1 if the program gives nothing or does not end.
inline Ended endedByBadRow(const QStringList& arguments, const QByteArray& row)
{
    constexpr int patience = 20'000; // milliseconds
    QProcess process;
    process.start(QStringLiteral(CLEARCUT_BINARY), arguments);
    process.write(row);
    const bool answered = process.waitForReadyRead(patience);
    process.write("bad\n");
    const bool ended = process.waitForFinished(patience);
    return {answered && ended ? process.exitCode() : -1, process.readAllStandardOutput(),
            process.readAllStandardError()};
}
