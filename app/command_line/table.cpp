// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/table.h"

#include "app/command_line/refusal.h"

namespace app {
namespace {

QStringList keys()
{
    QStringList keys;
    for (const TableFormat& format : tableFormats())
        keys << format.key;
    return keys;
}

} // namespace

Option tableOption()
{
    return {{"f", "format"}, keys().join(u'|'), Commands::tr("How to print the table (text).")};
}

TableFormat tableFormat(const Given& given)
{
    return tableFormats()[given.choice(QStringLiteral("format"), keys())];
}

} // namespace app
