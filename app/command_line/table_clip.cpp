// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/table_clip.h"

#include "app/base/csv_text.h"
#include "app/base/write_all.h"
#include "app/command_line/cut_options.h"
#include "app/command_line/input_bytes.h"
#include "app/command_line/refusal.h"
#include "app/command_line/terminal.h"
#include "app/command_line/window_options.h"
#include "app/document/document_builder.h"
#include "app/formats/csv/table_cut.h"

#include <QElapsedTimer>
#include <QThread>

namespace app {
namespace {

constexpr std::size_t mostThreads = 12; // each needs up to 3.5 MB, and all together at most 100 MB
constexpr std::size_t bytesForAThread = 1 << 18;

std::size_t threadsFor(const InputBytes& in)
{
    // One more than cores: one of them waits for bytes, or for its turn to write.
    const auto threads = std::min(std::size_t(QThread::idealThreadCount()) + 1, mostThreads);
    return in.size() ? std::min(threads, *in.size() / bytesForAThread + 1) : threads;
}

QString badRowText(const csv::BadRow& row)
{
    return Commands::tr("Skipped: line %1 %2").arg(row.line).arg(row.why);
}

void report(const ParsedArguments& arguments, const csv::TableCut& made, const CutOptions& options)
{
    Imported table = tableWithoutLines();
    table.report = made.report;
    sayLosses(table);
    const csv::TableCounts& counts = made.counts;
    if (counts.badRows > 0)
        say(Commands::tr("Bad rows skipped: %1.").arg(counts.badRows));
    say(shapesText(counts.lines) + u'.');
    if (const QString more = furtherCountsText(counts.lines); !more.isEmpty())
        say(more);
    say(windowText(arguments, table, options.region));
    if (counts.lines.whole + counts.lines.cut > 0)
        return;
    say(counts.bounds ? nothingLeftText(options.region.keep, placeText(*counts.bounds, table))
                      : Commands::tr("The drawing is empty: there is nothing to cut."));
}

csv::TableCut clipRows(InputBytes& in, const Output& output, csv::TableCutOptions options)
{
    csv::TableCut made;
    options.stopSource = [&] { in.stop(); };
    const auto source = [&](char* bytes, std::size_t size) { return in.read(bytes, size); };
    writeWith(
        [&](QIODevice& out) -> std::optional<QString> {
            const auto give = [&](std::string_view text) { return writeAll(out, text); };
            try {
                made = csv::cutTable(source, give, options);
            } catch (const csv::Refused& refused) {
                in.fail(Commands::tr("line %1 %2").arg(refused.line).arg(refused.why));
            }
            return std::nullopt;
        },
        output);
    return made;
}

} // namespace

std::vector<Option> tableClipOptions()
{
    return {{{"skip-bad"},
             {},
             Commands::tr("From csv to csv: skip rows that are not lines, and report the first "
                          "ones and their number. Otherwise such a row ends the command.")},
            {{"rows-only"},
             {},
             Commands::tr("From csv to csv: write neither the header nor the column source, so "
                          "that several outputs can be joined.")}};
}

QString tableLimit()
{
    return Commands::tr("From csv to csv with windows that need no drawing (a rectangle, circle, "
                        "polygon or file): any number of lines, cut as they are read.");
}

bool clipsTable(const ParsedArguments& arguments, const QString& input, const Output& output)
{
    bool wholeDrawing =
        arguments.has(QStringLiteral("occlude")) || arguments.has(QStringLiteral("tiles"))
        || arguments.has(QStringLiteral("in-place")) || !windowsNeedNoDrawing(arguments);
    wholeDrawing =
        wholeDrawing || output.format->key != "csv" || readFormatOf(arguments, input).key != "csv";
    for (const Option& option : tableClipOptions())
        if (wholeDrawing && arguments.has(option.names.back()))
            throw WrongUsage{
                Commands::tr("--%1 needs a table as input and output (csv), a window such as -w "
                             "0,0,100,50, and no option that needs all lines at once (--occlude, "
                             "--tiles, --in-place).")
                    .arg(option.names.back())};
    return !wholeDrawing;
}

Imported tableWithoutLines()
{
    Imported table;
    table.paged = false;
    DocumentBuilder builder;
    Page page;
    page.width = {page.size.x, Unit::Px};
    page.height = {page.size.y, Unit::Px};
    table.document = builder.take(page);
    return table;
}

void clipTable(const ParsedArguments& arguments, const QString& input, const Output& output,
               const CutOptions& options)
{
    QElapsedTimer timer;
    timer.start();
    InputBytes in(input);
    const bool quiet = arguments.has(QStringLiteral("quiet"));
    csv::TableCutOptions table{.cut = options, .write = output.options};
    if (options.region.keep == Keep::Inside)
        table.write.bounds = options.region.single();
    table.rowsOnly = arguments.has(QStringLiteral("rows-only"));
    table.skipBad = arguments.has(QStringLiteral("skip-bad"));
    table.threads = threadsFor(in);
    if (!quiet)
        table.sayBad = [](const csv::BadRow& row) { say(badRowText(row)); };
    const csv::TableCut made = clipRows(in, output, table);
    if (!made.complete)
        return;
    if (!quiet)
        report(arguments, made, options);
    if (arguments.has(QStringLiteral("stats")))
        say(Commands::tr("Lines: %1 before, %2 after; %3 ms.")
                .arg(made.counts.lines.segmentsBefore)
                .arg(made.counts.lines.segmentsAfter)
                .arg(timer.elapsed()));
}

} // namespace app
