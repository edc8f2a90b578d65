// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <string_view>
#include <vector>

namespace app {

class Given;

/// What a command ends with (product conventions).
enum class Exit : int { Done = 0, Failed = 1, Usage = 2, CheckFailed = 3, Interrupted = 130 };

/// One row of a command's options: what is parsed, and what the help says.
struct Option {
    QStringList names; ///< without dashes, the short one first; the last one is asked for
    QString value;     ///< what it takes, as the help calls it; empty: nothing
    QString meaning;
};

/// One row of the catalogue of commands: `clearcut KEY …`. Data goes to stdout, all else to stderr.
struct Command {
    std::string_view key;
    QString usage;   ///< what follows the key: "INPUT -o OUTPUT [OPTIONS]"
    QString summary; ///< one sentence
    std::vector<Option> options;
    QStringList examples; ///< whole command lines
    qsizetype operands;   ///< how many arguments that are no options; others are a wrong usage
    void (*run)(const Given& given); ///< throws WrongUsage or Failure (refusal.h)
    bool paints = false;             ///< whether it needs fonts or OpenGL, and so a QGuiApplication
    QStringList limits{};            ///< how much it can take, a sentence each
};
std::vector<Command> commands();

/// Whether these arguments (without the program's name) are for a command, --help or --version,
/// and so need no display. A file that is called like a command is opened as ./NAME or -- NAME.
bool isCommandLine(const QStringList& arguments);

/// Runs them and returns the exit code. Needs an application (application.h), no display. From then
/// on a closed pipe is an error like others, and Ctrl-C ends with 130.
int runCommandLine(const QStringList& arguments);

} // namespace app
