// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/progress.h"
#include "app/base/replace_file.h"

#include <QElapsedTimer>
#include <QString>

namespace app {

/// Prints data on standard output; throws Failure if it cannot be written (a full disk). If the
/// reader of a pipe has ended (`| head`), nothing is written and there is no error.
void print(const QString& text);

/// The same for binary data: `write` writes to standard output.
void printWith(const Filling& write);

/// The same, without a buffer: the reader of a pipe gets what each write has written.
void printAtOnce(const Filling& write);

/// Prints a line for the person on standard error.
void say(const QString& line);

/// Opens substitutes for standard input, output and error if they are closed (`>&-`), so that no
/// opened file takes their place and receives messages. Call this first in main.
void holdStandardStreams();

/// Makes a file that grows beyond the system's limit (ulimit -f) a write error with its sentence,
/// instead of the end of the program. Call this in main, too.
void refuseLongFiles();

/// Makes a closed pipe a write error, and Ctrl-C exit code 130. A file that is being replaced stays
/// unchanged (QSaveFile).
void answerSignals();

/// Updates one line on standard error, "42 %, 12 s left", from half a second after its beginning to
/// its end; silent if standard error is not a terminal. One at a time.
class ProgressLine {
public:
    ProgressLine() { clock_.start(); }
    ~ProgressLine() { erase(); }
    Q_DISABLE_COPY_MOVE(ProgressLine)

    /// For a task during its lifetime; it never stops the task.
    Follower follower();
    void show(const Progress& progress);
    /// Erases the line that is shown, if any. Safe in a signal handler.
    static void erase();

private:
    QElapsedTimer clock_;
    int shown_ = -1; ///< in per cent
};

} // namespace app
