// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/command_line/command.h"
#include "app/command_line/table.h"
#include "app/command_line/terminal.h"
#include "app/judge/example_files.h"
#include "app/judge/judge.h"

#include <limits>

namespace app {
namespace {

constexpr quint64 mostSeconds = 100; ///< the child's own limit is 120

void writeExample(const QString& folder)
{
    const auto result = plug_in::writeExample(folder, plug_in::Existing::Keep);
    if (!result)
        throw Failure{result.error};
    for (const QString& path : result.value->written)
        say(Text::tr("%1 was written.").arg(path));
    for (const QString& path : result.value->kept)
        say(Text::tr("%1 was kept, because it differs from the file that would replace it.")
                .arg(path));
}

plug_in::Case caseOf(const ParsedArguments& arguments)
{
    using Race = plug_in::Case::Race;
    plug_in::Case which{.library = arguments.operands().first()};
    which.seed = arguments.count(QStringLiteral("seed"), 0, std::numeric_limits<quint64>::max())
                     .value_or(which.seed);
    if (arguments.has(QStringLiteral("strict")))
        which.contract.strictness = plug_in::Strictness::Clearcuts;
    which.seconds = double(arguments.count(QStringLiteral("seconds"), 1, mostSeconds)
                               .value_or(std::uint64_t(which.seconds)));
    which.race = arguments.has(QStringLiteral("no-race")) ? Race::No : Race::Yes;
    return which;
}

plug_in::Verdict judged(const plug_in::Case& which)
{
    ProgressLine line;
    return *plug_in::judge(which, line.follower());
}

void judge(const ParsedArguments& arguments)
{
    if (arguments.has(QStringLiteral("save-example")))
        return writeExample(arguments.operands().first());
    const plug_in::Case which = caseOf(arguments);
    const TableOutput output = tableOutput(arguments);
    const plug_in::Verdict verdict = judged(which);
    if (verdict.unusable)
        throw Failure{
            (QStringList{plug_in::sentence(verdict)} + plug_in::remarks(verdict)).join(u' ')};
    const bool isText = output.format.key == tableFormats().front().key;
    auto tables =
        plug_in::tablesOf(verdict, isText ? plug_in::Reader::Terminal : plug_in::Reader::File);
    if (isText) // the first line has scrolled off the screen by then
        tables.push_back({.names = {}, .title = plug_in::sentence(verdict)});
    writeTables(output, tables);
    if (!verdict.passed())
        throw CheckFailed{};
}

} // namespace

Command judgeCommand()
{
    std::vector<Option> options{
        {{"strict"},
         {},
         Text::tr("Apply the contract of Clearcut's own algorithms: no end outside the window, "
                  "not even by rounding.")},
        {{"seed"}, "N", Text::tr("Seed of the random lines (1).")},
        {{"no-race"}, {}, Text::tr("Do not time the algorithm.")},
        {{"seconds"},
         "N",
         Text::tr(
             "Limit of the processor time for the tests (30 s); the limit by wall clock is three "
             "times as long. At the limit, the verdict covers the tests so far.")},
        {{"save-example"},
         {},
         Text::tr(
             "Instead of judging, write the header, a skeleton to fill in and examples to compile "
             "into the folder LIBRARY. Files that you have changed there are kept.")}};
    const auto more = tableOptions();
    options.insert(options.end(), more.begin(), more.end());
    return {"judge",
            "LIBRARY [OPTIONS]",
            Text::tr("Judges your own algorithm, a shared library with one function, and times "
                     "it beside every other algorithm. The exit code is 3 if it is wrong. A "
                     "library is a program: it runs with your rights, in a separate process."),
            std::move(options),
            {"clearcut judge --save-example .", "clearcut judge ./example.so",
             "clearcut judge ./mine.so --strict --no-race --format json"},
            1,
            judge};
}

} // namespace app
