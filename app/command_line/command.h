// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <string_view>
#include <vector>

namespace app {

class ParsedArguments;

/// The exit codes of a command.
enum class Exit : int { Done = 0, Failed = 1, Usage = 2, CheckFailed = 3, Interrupted = 130 };

/// One row of a command's options: what is parsed, and its help.
struct Option {
    QStringList names; ///< without dashes, the short one first; code uses the last one
    QString value;     ///< the name of its value in the help; empty: no value
    QString meaning;
};

/// Whether a command needs a QGuiApplication: for the fonts of texts in drawings, without a
/// display, or to paint pictures, perhaps with OpenGL.
enum class Paints : std::uint8_t { Nothing, Letters, Pictures };

/// One row of the catalogue of commands: `clearcut KEY …`. Data goes to stdout, everything else to
/// stderr.
struct Command {
    std::string_view key;
    QString usage;   ///< the text after the key: "INPUT -o OUTPUT [OPTIONS]"
    QString summary; ///< one sentence
    std::vector<Option> options;
    QStringList examples;                          ///< whole command lines
    qsizetype operands;                            ///< the number of arguments that are not options
    void (*run)(const ParsedArguments& arguments); ///< throws WrongUsage or Failure
    Paints paints = Paints::Nothing;
    QStringList limits{};        ///< limits of its input, a sentence each
    bool lastIsOptional = false; ///< the last operand may be left out
    bool lastRepeats = false;    ///< the last operand may be given several times
};
std::vector<Command> commands();

/// Whether these arguments (without the program's name) are a command, --help or --version, and
/// therefore need no display. A file with the name of a command is opened as ./NAME or -- NAME.
bool isCommandLine(const QStringList& arguments);

/// Runs the command and returns the exit code. Needs an application (application.h) but no display.
/// From then on a closed pipe is an ordinary error, and Ctrl-C ends with 130.
int runCommandLine(const QStringList& arguments);

} // namespace app

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
