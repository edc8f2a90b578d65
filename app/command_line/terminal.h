// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace app {

/// Data, to standard output; throws Failure if it cannot be written (a full disk, a closed pipe).
void print(const QString& text);

/// A line for the person, to standard error.
void say(const QString& line);

/// Makes a closed pipe an error that writing reports, and Ctrl-C the exit code 130. A file that is
/// being replaced stays as it was (QSaveFile).
void answerSignals();

/// While it lives, Ctrl-C also removes the half of a file that lies beside `path` to replace it.
class Unfinished {
public:
    explicit Unfinished(const QString& path);
    ~Unfinished();
    Q_DISABLE_COPY_MOVE(Unfinished)
};

} // namespace app
