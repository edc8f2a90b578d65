// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/replace_file.h"
#include "app/base/text.h"
#include "app/command_line/command.h"
#include "app/command_line/parsed_arguments.h"
#include "app/command_line/terminal.h"

#include <QLocale>

#include <algorithm>
#include <new>
#include <optional>

namespace app {

// Each is defined in the file of its command.
Command clipCommand();
Command compareCommand();
Command convertCommand();
Command costmapCommand();
Command algorithmsCommand();
Command benchCommand();
Command infoCommand();
Command judgeCommand();
Command lessonCommand();
Command helpCommand();
Command traceCommand();

// THE CATALOGUE. To add a command: write its file in app/command_line/, and name it in both lists.
std::vector<Command> commands()
{
    // clang-format off
    return {
        clipCommand(),
        convertCommand(),
        compareCommand(),
        infoCommand(),
        traceCommand(),
        costmapCommand(),
        algorithmsCommand(),
        benchCommand(),
        judgeCommand(),
        lessonCommand(),
        helpCommand(),
    };
    // clang-format on
}

namespace {

// Searches the options, which end at --.
bool asks(const QStringList& arguments, const QStringList& names)
{
    const auto end = std::find(arguments.begin(), arguments.end(), QStringLiteral("--"));
    return std::find_first_of(arguments.begin(), end, names.begin(), names.end()) != end;
}

bool asksForVersion(const QStringList& arguments) { return asks(arguments, {"-V", "--version"}); }
bool asksForHelp(const QStringList& arguments) { return asks(arguments, {"-h", "--help"}); }

std::optional<Command> commandOf(const QStringList& arguments)
{
    for (Command& command : commands())
        if (!arguments.isEmpty() && arguments.first() == QLatin1StringView(command.key))
            return std::move(command);
    return std::nullopt;
}

QString commandOverview()
{
    std::vector<std::pair<QString, QString>> rows;
    for (const Command& command : commands())
        rows.emplace_back(QLatin1StringView(command.key), command.summary);
    return Text::tr("Usage: clearcut [FILE …]               opens the editor\n"
                    "       clearcut COMMAND [OPTIONS]      works without a display\n"
                    "       clearcut COMMAND --help         shows the help of a command\n"
                    "       clearcut --version\n\nOptions of the editor:\n")
           + aligned(
               {{"--renderer auto|opengl|raster", Text::tr("What draws the canvas.")},
                {"--theme system|light|dark", Text::tr("The theme of the window.")},
                {"--size WIDTHxHEIGHT", Text::tr("The size of the window.")},
                {"--panes 1|2|4|all", Text::tr("How many algorithms are shown side by side.")},
                {"--algorithm KEY", Text::tr("The algorithm that clips, such as LB.")},
                {"--microscope LINE|first",
                 Text::tr("Open the microscope at \"10, 20 -> 70, 130\", or at the first line.")},
                {"--step N", Text::tr("The step that the microscope shows.")},
                {"--new-window", Text::tr("Do not open the files in the window that is open.")},
                {"--verbose", Text::tr("Print when the first frame was shown.")},
                {"--screenshot FILE.png", Text::tr("Save a picture of the window and end.")}})
           + Text::tr("\nCommands:\n") + aligned(rows) + u'\n'
           + wrapped(Text::tr("Exit codes: 0 done, 1 failed, 2 wrong usage, 3 something "
                              "differs, 130 interrupted."),
                     0);
}

// Also for folders and libraries, which no format examines.
void refuseLostNames(const QStringList& arguments)
{
    for (const QString& argument : arguments)
        if (const auto fault = faultOfName(argument))
            throw Failure{Text::tr("Cannot use %1: %2").arg(argument, *fault)};
}

void run(const Command& command, const QStringList& arguments)
{
    const ParsedArguments parsed(command, arguments);
    if (parsed.helpWanted())
        print(helpOf(command));
    else
        command.run(parsed);
}

} // namespace

bool isCommandLine(const QStringList& arguments)
{
    return commandOf(arguments) || asksForVersion(arguments) || asksForHelp(arguments);
}

int runCommandLine(const QStringList& arguments)
{
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); // the same everywhere
    answerSignals();
    const auto command = commandOf(arguments);
    const QString name = command ? QLatin1StringView(command->key) : QString();
    try {
        refuseLostNames(arguments);
        if (command)
            run(*command, arguments.sliced(1));
        else if (asksForVersion(arguments))
            print(QStringLiteral("clearcut " CLEARCUT_VERSION "\n"));
        else
            print(commandOverview());
        return int(Exit::Done);
    } catch (const WrongUsage& wrong) {
        say(QStringLiteral("clearcut %1: %2").arg(name, wrong.sentence));
        say(Text::tr("“clearcut %1 --help” says more.").arg(name));
        return int(Exit::Usage);
    } catch (const Failure& failure) {
        say(QStringLiteral("clearcut %1: %2").arg(name, failure.sentence));
        return int(Exit::Failed);
    } catch (const CheckFailed&) {
        return int(Exit::CheckFailed);
    } catch (const std::bad_alloc&) {
        say(Text::tr("clearcut %1: There is not enough memory for this.").arg(name));
        return int(Exit::Failed);
    }
}

} // namespace app
