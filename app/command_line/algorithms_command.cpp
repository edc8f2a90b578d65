// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/given.h"
#include "app/command_line/refusal.h"
#include "app/command_line/table.h"

namespace app {
namespace {

void list(const Given& given)
{
    Table table{{"key", "abbreviation", "name", "year", "idea"}};
    for (const auto& algorithm : clipping::algorithms())
        table.rows.push_back({QLatin1StringView(algorithm.key),
                              QLatin1StringView(algorithm.abbreviation),
                              QLatin1StringView(algorithm.name), QString::number(algorithm.year),
                              QString::fromUtf8(algorithm.idea)});
    writeTables(tableOutput(given), {&table, 1});
}

} // namespace

Command algorithmsCommand()
{
    return {"algorithms",
            "[OPTIONS]",
            Commands::tr("Lists the algorithms that clip."),
            tableOptions(),
            {"clearcut algorithms --format csv"},
            0,
            list};
}

} // namespace app
