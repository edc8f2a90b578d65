// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/table.h"

#include "app/base/replace_file.h"
#include "app/base/text.h"
#include "app/base/write_all.h"
#include "app/command_line/command.h"
#include "app/command_line/terminal.h"

#include <QFileInfo>

#include <algorithm>

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

std::vector<Option> tableOptions()
{
    return {
        {{"f", "format"},
         keys().join(u'|'),
         Text::tr("Format of tables (text, or by the ending of FILE).")},
        {{"o", "output"}, "FILE", Text::tr("Where to write tables (standard output).")},
    };
}

TableOutput tableOutput(const ParsedArguments& arguments)
{
    const auto formats = tableFormats();
    TableOutput output{formats[arguments.choice(QStringLiteral("format"), keys())],
                       arguments.text(QStringLiteral("output")).value_or(QString())};
    const auto byEnding =
        std::ranges::find(formats, QFileInfo(output.path).suffix().toLower(), &TableFormat::ending);
    if (!arguments.has(QStringLiteral("format")) && byEnding != formats.end())
        output.format = *byEnding;
    return output;
}

void writeTables(const TableOutput& output, std::span<const Table> tables)
{
    const QString text = output.format.text(tables);
    if (output.path.isEmpty() || output.path == u"-")
        return print(text);
    const auto error = replaceFile(output.path, [&](QIODevice& out) {
        const bool all = writeAll(out, text.toStdString());
        return all ? std::nullopt : std::optional(out.errorString() + u'.');
    });
    if (error)
        throw Failure{Text::tr("Cannot write %1: %2").arg(output.path, *error)};
}

} // namespace app
