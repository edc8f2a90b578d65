// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/command_line/command.h"
#include "app/command_line/table_compare.h"
#include "app/command_line/terminal.h"
#include "app/command_line/window_options.h"

#include <algorithm>
#include <numeric>

namespace app {
namespace {

constexpr quint64 mostUlps = 1'000'000'000;

Comparison comparisonOf(const ParsedArguments& arguments)
{
    if (!arguments.has(QStringLiteral("algorithm")))
        throw WrongUsage{Text::tr("Name the algorithm to compare with -a.")};
    Comparison comparison{*arguments.variant(QStringLiteral("algorithm")),
                          arguments.variant(QStringLiteral("with")).value_or(exactVariant())};
    if (const auto ulps = arguments.count(QStringLiteral("ulps"), 0, mostUlps))
        comparison.ulps = double(*ulps);
    if (comparison.a == comparison.b)
        throw WrongUsage{Text::tr("-a and -b are the same: choose two different ones.")};
    return comparison;
}

// The one window at which both can clip.
ClipRegion regionOf(const ParsedArguments& arguments, const Imported& imported,
                    const Comparison& comparison)
{
    ClipRegion region =
        app::regionOf(comparedWindowsOf(arguments, imported), imported.document.page());
    for (const Variant& variant : {comparison.a, comparison.b})
        if (const QString refusal = refusalAt(region.steps.front(), variant); !refusal.isEmpty())
            throw WrongUsage{refusal};
    return region;
}

// The lines of a table in the order of its rows. In the document they are grouped by layer.
void compareRows(const std::vector<std::uint32_t>& rowOfObject, const SceneLines& lines,
                 DifferenceRows& rows)
{
    std::vector<std::size_t> order(lines.size()); // the line of each row
    std::iota(order.begin(), order.end(), 0);
    const auto rowOf = [&](std::size_t line) { return rowOfObject[lines.objectOf(line)]; };
    std::ranges::sort(order, {}, rowOf);
    std::vector<clipping::Segment> ordered;
    std::ranges::transform(order, std::back_inserter(ordered),
                           [&](std::size_t line) { return lines[line]; });
    rows.compare(ordered, [&](std::size_t i) {
        const std::size_t row = rowOf(order[i]) + 1;
        return DifferenceRows::Numbers{row, row};
    });
}

// The lines of a drawing, each with its number and that of its object.
void compareRuns(const SceneLines& lines, DifferenceRows& rows, DifferenceOutput& output)
{
    for (const SceneLines::Run& run : lines.runs()) {
        rows.compare(run.segments, [&](std::size_t i) {
            const std::size_t line = run.firstLine + i;
            return DifferenceRows::Numbers{line + 1, lines.objectOf(line) + 1};
        });
        output.give(rows);
    }
}

// Compares all lines even if the reader of the rows has ended, for the report.
void compareDrawing(const Imported& imported, const ComparedAt& at, DifferenceOutput& output)
{
    const EditedDocument document(imported.document);
    const Scene scene(document);
    const SceneLines& lines = scene.lines();
    DifferenceRows rows(at, output.form());
    output.write([&] {
        output.begin();
        if (imported.rows.empty()) {
            compareRuns(lines, rows, output);
        } else {
            compareRows(imported.rows, lines, rows);
            output.give(rows);
        }
    });
}

void compare(const ParsedArguments& arguments)
{
    const Comparison comparison = comparisonOf(arguments);
    const TableOutput target = tableOutput(arguments);
    const QString input = arguments.operands().first();
    const bool table = comparesTable(arguments, input);
    const Imported imported = table ? tableWithoutLines() : readDrawing(arguments, input);
    const ComparedAt at{comparison, regionOf(arguments, imported, comparison)};
    DifferenceOutput output(at, target, arguments.has(QStringLiteral("summary")));
    csv::TableStreamed streamed;
    if (table)
        streamed = compareTable(arguments, input, at, output);
    else
        compareDrawing(imported, at, output);
    if (streamed.complete && !arguments.has(QStringLiteral("quiet"))) {
        sayLosses(table ? streamed.report : imported.report);
        sayBadRows(streamed);
        say(windowText(arguments, imported, at.window));
        say(output.summary());
    }
    if (output.totals().counts.all() > 0)
        throw CheckFailed{};
}

} // namespace

Command compareCommand()
{
    std::vector<Option> options{
        {{"a", "algorithm"},
         "A",
         Text::tr("Key or abbreviation of the algorithm; KEY:published is the form that its "
                  "authors printed, md-step-2 the paper's misprint.")},
        {{"b", "with"}, "B", Text::tr("The algorithm to compare with (exact).")},
        {{"ulps"},
         "N",
         Text::tr("How far apart ends may be, 0 to %1 ulps (what the contracts of both allow). "
                  "Ulps are units in the last place of the largest coordinate of line and window.")
             .arg(mostUlps)},
    };
    const std::vector<Option> last{
        {{"summary"}, {}, Text::tr("Print only a summary of the lines that differ.")},
        {{"q", "quiet"}, {}, Text::tr("Do not report the window and the number of lines.")}};
    for (const auto& more :
         {comparedWindowOptions(), tableOptions(), readingOptions(), tableCompareOptions(), last})
        options.insert(options.end(), more.begin(), more.end());
    return {"compare",
            "INPUT -a A [-b B] [OPTIONS]",
            Text::tr("Lists the lines that two algorithms clip differently. The exit code is 3 "
                     "if there are any."),
            std::move(options),
            {"clearcut compare plan.svg -a kwc:published",
             "clearcut compare map.svg -w 0,0,210mm,297mm -a md -b lb --ulps 0 --format csv",
             "clearcut compare map.svg -w circle:50mm,50mm,20mm -a skala",
             "clearcut compare - --from csv -w -100,-75,100,75 -a nln --ulps 0 -f csv < lines.csv"},
            1,
            compare,
            Paints::Letters,
            readingLimits() << tableCompareLimit()};
}

} // namespace app
