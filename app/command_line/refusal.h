// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

// Exceptions of commands; runCommandLine prints the sentence and ends the program.

namespace app {

/// Invalid arguments: exit code 2, and a hint at the help.
struct WrongUsage {
    QString sentence;
};

/// Failed (a file, the disk): exit code 1.
struct Failure {
    QString sentence;
};

/// The command ran, but its check failed: exit code 3. The result has been printed.
struct CheckFailed {};

} // namespace app
