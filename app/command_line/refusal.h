// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

// What a command throws instead of going on; runCommandLine says the sentence and ends the program.

namespace app {

/// The arguments make no sense: exit code 2, and the way to the help.
struct WrongUsage {
    QString sentence;
};

/// It could not be done (a file, the disk): exit code 1.
struct Failure {
    QString sentence;
};

/// All was done, and what was asked for is not so: exit code 3. What is, was said.
struct CheckFailed {};

/// The texts of the command line: Commands::tr("...").
struct Commands {
    Q_DECLARE_TR_FUNCTIONS(Commands)
};

} // namespace app
