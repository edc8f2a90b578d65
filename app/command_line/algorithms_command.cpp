// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/command_line/command.h"
#include "app/command_line/parsed_arguments.h"
#include "app/command_line/table.h"

namespace app {
namespace {

void list(const ParsedArguments& arguments)
{
    const TableOutput output = tableOutput(arguments);
    // Text output has no column of names: the ideas need the width, and keys resemble names.
    const bool isText = output.format.key == tableFormats().front().key;
    Table table{isText ? QStringList{"key", "abbr.", "year", "idea"}
                       : QStringList{"key", "abbreviation", "name", "year", "idea"}};
    for (const auto& algorithm : clipping::algorithms()) {
        QStringList row{QLatin1StringView(algorithm.key), QLatin1StringView(algorithm.abbreviation),
                        QString::number(algorithm.year), QString::fromUtf8(algorithm.idea)};
        if (!isText)
            row.insert(2, QLatin1StringView(algorithm.name));
        table.rows.push_back(row);
    }
    writeTables(output, {&table, 1});
}

} // namespace

Command algorithmsCommand()
{
    return {"algorithms",
            "[OPTIONS]",
            Text::tr("Lists the algorithms that clip."),
            tableOptions(),
            {"clearcut algorithms --format csv"},
            0,
            list};
}

} // namespace app
