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

} // namespace app
