// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <span>
#include <string_view>

namespace app {

/// What a command ends with (product conventions).
enum class Exit : int { Done = 0, Failed = 1, Usage = 2, CheckFailed = 3, Interrupted = 130 };

/// One row of the catalogue of commands: `clearcut KEY …`. Data goes to stdout, all else to stderr.
struct Command {
    std::string_view key;
    QString summary;
    QString help; ///< what `clearcut KEY --help` prints
    Exit (*run)(const QStringList& arguments);
};
std::span<const Command> commands();

/// Whether these arguments (without the program's name) are for a command, --help or --version,
/// and so need no display.
bool isCommandLine(const QStringList& arguments);

/// Runs them. Needs a QCoreApplication or QGuiApplication, no display.
int runCommandLine(const QStringList& arguments);

} // namespace app
