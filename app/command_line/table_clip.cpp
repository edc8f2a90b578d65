// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/table_clip.h"

#include "app/base/text.h"
#include "app/base/write_all.h"
#include "app/command_line/command.h"
#include "app/command_line/cut_options.h"
#include "app/command_line/table_input.h"
#include "app/command_line/terminal.h"
#include "app/command_line/window_options.h"
#include "app/formats/csv/table_cut.h"

#include <QElapsedTimer>

namespace app {
namespace {

void reportTableCut(const ParsedArguments& arguments, const csv::TableCut& made,
                    const CutOptions& options)
{
    const Imported table = tableWithoutLines();
    sayLosses(made.stream.report);
    const csv::TableCounts& counts = made.counts;
    sayBadRows(made.stream);
    say(shapesText(counts.lines, true) + u'.');
    sayPoints(counts.points);
    if (const QString more = furtherCountsText(counts.lines); !more.isEmpty())
        say(more);
    say(windowText(arguments, table, options.region));
    if (counts.lines.whole + counts.lines.cut + counts.lines.touching > 0)
        return;
    say(counts.bounds
            ? nothingLeftText(options.region.keep, placeText(*counts.bounds, table), counts.lines)
            : Text::tr("The drawing is empty: there is nothing to cut."));
}

csv::TableCut clipRows(InputBytes& in, const ParsedArguments& arguments, const Output& output,
                       const csv::CutRows& rows)
{
    csv::TableCut made;
    writeWith(
        [&](QIODevice& out) -> std::optional<QString> {
            const auto give = [&](std::string_view text) { return writeAll(out, text); };
            const auto cut = [&](csv::ByteSource source, csv::TableStreamOptions options) {
                made = csv::cutTable(std::move(source), give, {rows, std::move(options)});
                return made.stream;
            };
            streamed(in, arguments, cut);
            return std::nullopt;
        },
        output.path);
    return made;
}

} // namespace

std::vector<Option> tableClipOptions()
{
    return {skipBadOption(
                Text::tr("From csv to csv: any number of lines, cut as they are read. Windows must "
                         "need no drawing: a rectangle, circle, polygon or file.")),
            {{"rows-only"},
             {},
             Text::tr("From csv to csv: write neither the header nor the column source, so "
                      "that several outputs can be joined.")}};
}

QString tableLimit()
{
    return Text::tr("From csv to csv with windows that need no drawing (a rectangle, circle, "
                    "polygon or file): any number of lines, cut as they are read.");
}

bool clipsTable(const ParsedArguments& arguments, const QString& input, const Output& output)
{
    bool wholeDrawing =
        arguments.has(QStringLiteral("occlude"))
        || arguments.has(QStringLiteral("strokes-as-areas"))
        || arguments.has(QStringLiteral("tiles")) || arguments.has(QStringLiteral("in-place"))
        || arguments.has(QStringLiteral("layer")) || arguments.has(QStringLiteral("join"))
        || arguments.has(QStringLiteral("fit-paper")) || !windowsNeedNoDrawing(arguments);
    wholeDrawing =
        wholeDrawing || output.format->key != "csv" || readFormatOf(arguments, input).key != "csv";
    for (const Option& option : tableClipOptions())
        if (wholeDrawing && arguments.has(option.names.back()))
            throw WrongUsage{
                Text::tr("--%1 needs a table (csv) as input and output, and a window such as -w "
                         "0,0,100,50. Leave out --occlude, --strokes-as-areas, --tiles, --layer, "
                         "--join, --fit-paper and --in-place, which need all lines at once.")
                    .arg(option.names.back())};
    return !wholeDrawing;
}

void clipTable(const ParsedArguments& arguments, const QString& input, const Output& output,
               const CutOptions& options)
{
    QElapsedTimer timer;
    timer.start();
    InputBytes in(input);
    csv::CutRows rows{.cut = options, .write = output.options};
    if (options.region.keep == Keep::Inside)
        rows.write.bounds = options.region.single();
    rows.page = tableWithoutLines().document.page();
    rows.rowsOnly = arguments.has(QStringLiteral("rows-only"));
    const csv::TableCut made = clipRows(in, arguments, output, rows);
    if (!made.stream.complete)
        return;
    if (!arguments.has(QStringLiteral("quiet")))
        reportTableCut(arguments, made, options);
    if (arguments.has(QStringLiteral("stats")))
        say(Text::tr("Lines: %1 before, %2 after; %3 ms.")
                .arg(made.counts.lines.segmentsBefore)
                .arg(made.counts.lines.segmentsAfter)
                .arg(timer.elapsed()));
}

} // namespace app
