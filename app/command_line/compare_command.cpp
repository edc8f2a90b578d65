// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/number.h"
#include "app/command_line/drawing_files.h"
#include "app/command_line/refusal.h"
#include "app/command_line/table.h"
#include "app/command_line/terminal.h"
#include "app/command_line/window_options.h"
#include "app/comparison/differences_at.h"
#include "app/formats/rectangle_text.h"

#include <array>
#include <cmath>

namespace app {
namespace {

constexpr quint64 mostUlps = 1'000'000'000;

/// In tables: which variant sees the line.
constexpr std::array words{"only_a", "only_b", "ends"}; // in the order of Difference::Kind

Comparison comparisonOf(const ParsedArguments& arguments)
{
    if (!arguments.has(QStringLiteral("algorithm")))
        throw WrongUsage{Commands::tr("Name the algorithm to compare with -a.")};
    Comparison comparison{*arguments.variant(QStringLiteral("algorithm")),
                          arguments.variant(QStringLiteral("with")).value_or(exactVariant())};
    if (const auto ulps = arguments.count(QStringLiteral("ulps"), 0, mostUlps))
        comparison.ulps = double(*ulps);
    if (comparison.a == comparison.b)
        throw WrongUsage{Commands::tr("-a and -b are the same: choose two different ones.")};
    return comparison;
}

QString number(double value)
{
    if (!std::isfinite(value))
        return std::isnan(value) ? QStringLiteral("nan") : QStringLiteral("inf");
    std::string text;
    appendNumber(text, value);
    return QString::fromStdString(text);
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

void append(QStringList& row, const std::vector<clipping::Clipped>& pieces)
{
    const auto piece = pieces.empty() ? std::nullopt : std::optional(pieces.front().segment);
    for (const std::size_t i : {0, 1, 2, 3})
        row << (piece ? number((i < 2 ? piece->a : piece->b)[int(i % 2)]) : QString());
}

QStringList rowOf(const Difference& difference, const Comparison& comparison, const Scene& scene,
                  const ClipRegion& region)
{
    const clipping::Segment line = scene.lines()[difference.source];
    QStringList row{QString::number(difference.source + 1),
                    QString::number(scene.lines().objectOf(difference.source) + 1),
                    QLatin1StringView(words[std::size_t(difference.kind)]),
                    QString::number(difference.ulps, 'g', 6)};
    append(row, clippedAt(region, comparison.a, {&line, 1}));
    append(row, clippedAt(region, comparison.b, {&line, 1}));
    return row;
}

Table tableOf(const Comparison& comparison, const Scene& scene, const ClipRegion& region,
              const Differences& found, const QString& title)
{
    Table table{.names = {"line", "shape", "differs", "ulps", "a_x1", "a_y1", "a_x2", "a_y2",
                          "b_x1", "b_y1", "b_x2", "b_y2"},
                .title = title,
                .key = QStringLiteral("differences"),
                .facts = {{"a", keyOf(comparison.a)},
                          {"b", keyOf(comparison.b)},
                          {"ulps_allowed", QString::number(allowedAt(region, comparison))},
                          {"window", rectangleText(found.window)},
                          {"lines", QString::number(found.lines)},
                          {"differing", QString::number(found.list.size())}}};
    for (const Difference& difference : found.list)
        table.rows.push_back(rowOf(difference, comparison, scene, region));
    return table;
}

/// The facts about all lines in one row, without the lines that differ.
Table summed(Table table)
{
    table.names.clear();
    table.rows = {{}};
    for (const auto& [name, value] : table.facts) {
        table.names << name;
        table.rows.front() << value;
    }
    table.facts.clear();
    return table;
}

void compare(const ParsedArguments& arguments)
{
    const Comparison comparison = comparisonOf(arguments);
    const TableOutput output = tableOutput(arguments);
    const Imported imported = readDrawing(arguments, arguments.operands().first());
    const EditedDocument document(imported.document);
    const Scene scene(document);
    const ClipRegion region = regionOf(arguments, imported, comparison);
    const Differences found = differencesAt(region, comparison, scene.lines());
    const QString summary =
        sentence(comparison.a, comparison.b, counted(found.list), found.lines) + u'.';
    // In text format, a summary or a comparison without differences prints only the sentence.
    const bool forPerson = output.format.key == QStringLiteral("text");
    const bool whole = !arguments.has(QStringLiteral("summary"));
    Table table = tableOf(comparison, scene, region, found, summary);
    if (!whole)
        table = summed(std::move(table));
    if (!forPerson || (whole && !found.list.empty()))
        writeTables(output, {&table, 1});
    if (!arguments.has(QStringLiteral("quiet"))) {
        say(windowText(arguments, imported, region));
        say(summary);
    }
    if (!found.list.empty())
        throw CheckFailed{};
}

} // namespace

Command compareCommand()
{
    std::vector<Option> options{
        {{"a", "algorithm"},
         "A",
         Commands::tr("Key or abbreviation of the algorithm; KEY:published is the form that its "
                      "authors printed, md-step-2 the paper's misprint.")},
        {{"b", "with"}, "B", Commands::tr("The algorithm to compare with (exact).")},
        {{"ulps"},
         "N",
         Commands::tr("How far apart ends may be, in ulps (units in the last place) of the largest "
                      "coordinate of line and window, 0 to %1 (what the contracts of both allow).")
             .arg(mostUlps)},
    };
    const std::vector<Option> last{
        {{"summary"}, {}, Commands::tr("Print only a summary of the lines that differ.")},
        {{"q", "quiet"}, {}, Commands::tr("Do not report the window and the number of lines.")}};
    for (const auto& more : {comparedWindowOptions(), tableOptions(), readingOptions(), last})
        options.insert(options.end(), more.begin(), more.end());
    return {"compare",
            "INPUT -a A [-b B] [OPTIONS]",
            Commands::tr("Lists the lines that two algorithms clip differently. The exit code is 3 "
                         "if there are any."),
            std::move(options),
            {"clearcut compare plan.svg -a kwc:published",
             "clearcut compare map.svg -w 0,0,210mm,297mm -a md -b lb --ulps 0 --format csv",
             "clearcut compare map.svg -w circle:50mm,50mm,20mm -a skala"},
            1,
            compare,
            false,
            readingLimits()};
}

} // namespace app
