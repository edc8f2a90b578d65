// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/latin.h"
#include "app/command_line/refusal.h"
#include "app/command_line/table.h"
#include "app/formats/format.h"

namespace app {
namespace {

void list(const ParsedArguments& arguments)
{
    Table table{.names = {"key", "name"}};
    for (const Format& format : formats())
        table.rows.push_back({latin(format.key), format.name});
    writeTables(tableOutput(arguments), {&table, 1});
}

} // namespace

Command formatsCommand()
{
    return {"formats",
            "[OPTIONS]",
            Commands::tr("Lists the file formats of drawings."),
            tableOptions(),
            {"clearcut formats --format csv"},
            0,
            list};
}

} // namespace app
