// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/replace_file.h"

#include <QString>

namespace app {

/// Data, to standard output; throws Failure if it cannot be written (a full disk). Where the reader
/// of a pipe has gone (`| head`) nothing is written, and that is no error.
void print(const QString& text);

/// The same for what is not text: `write` fills standard output.
void printWith(const Filling& write);

/// A line for the person, to standard error.
void say(const QString& line);

/// Puts something in the place of standard input, output and error where they are closed (`>&-`),
/// so that no file is opened in their place and has messages written into it. First of all in main.
void holdStandardStreams();

/// Makes a closed pipe an error that writing reports, and Ctrl-C the exit code 130. A file that is
/// being replaced stays as it was (QSaveFile).
void answerSignals();

} // namespace app
