// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/table_compare.h"

#include "app/base/text.h"
#include "app/command_line/command.h"
#include "app/command_line/window_options.h"

namespace app {
namespace {

class CompareWork final : public csv::BlockWork {
public:
    CompareWork(const ComparedAt& at, DifferenceOutput& output)
        : rows_(at, output.form()), output_(output)
    {
    }

    void work(const csv::TableRows& table) override
    {
        rows_.compare(table.lines(), [&](std::size_t line) {
            const std::size_t row = table.rowOf(line) + 1;
            return DifferenceRows::Numbers{row, row};
        });
    }

    bool give() override { return output_.give(rows_); }

private:
    DifferenceRows rows_;
    DifferenceOutput& output_;
};

} // namespace

std::vector<Option> tableCompareOptions()
{
    return {skipBadOption(
        Text::tr("From csv: skip rows that are not lines, and report the first ones and their "
                 "number. Otherwise such a row ends the command. The window must be given."))};
}

QString tableCompareLimit()
{
    return Text::tr("From csv with a given window (-w): any number of lines, compared as they "
                    "are read. --format csv prints each row at once; the other formats keep "
                    "the rows that differ in memory until the end.");
}

bool comparesTable(const ParsedArguments& arguments, const QString& input)
{
    const bool table =
        windowsNeedNoDrawing(arguments) && readFormatOf(arguments, input).key == "csv";
    if (!table && arguments.has(QStringLiteral("skip-bad")))
        throw WrongUsage{Text::tr("--skip-bad needs a table as input (csv) and a window such "
                                  "as -w 0,0,100,50.")};
    return table;
}

csv::TableStreamed compareTable(const ParsedArguments& arguments, const QString& input,
                                const ComparedAt& at, DifferenceOutput& output)
{
    InputBytes in(input);
    const auto stream = [&](csv::ByteSource source, const csv::TableStreamOptions& options) {
        return csv::streamTable(
            std::move(source), options, [&] { return output.begin(); },
            [&] { return std::make_unique<CompareWork>(at, output); });
    };
    csv::TableStreamed made;
    output.write([&] { made = streamed(in, arguments, stream); });
    return made;
}

} // namespace app
