// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/tile_options.h"

#include "app/base/numbers.h"
#include "app/command_line/refusal.h"
#include "app/command_line/terminal.h"
#include "app/tiles/sheets.h"

#include <QFileInfo>
#include <QPageSize>
#include <QRegularExpression>

namespace app {
namespace {

const QString optionName = QStringLiteral("tiles");

double millimetres(const ParsedArguments& arguments, const QString& option, double usual,
                   const Page& page)
{
    const auto length = arguments.length(option);
    const double unit = page.millimetresPerUnit();
    return length ? toUserUnits(*length, unit) * unit : usual;
}

// "3x2": columns and rows.
bool takeNumbers(const QString& text, TilePlan& plan)
{
    static const QRegularExpression form(
        QStringLiteral("^([1-9][0-9]{0,3})[x×]([1-9][0-9]{0,3})$"));
    const auto found = form.match(text);
    if (found.hasMatch()) {
        plan.columns = found.captured(1).toInt();
        plan.rows = found.captured(2).toInt();
    }
    return found.hasMatch();
}

// "a4" or "a4-landscape": a size of paper.
bool takePaper(const QString& text, TilePlan& plan)
{
    const bool landscape = text.endsWith(QLatin1StringView("-landscape"));
    const QString name = landscape ? text.section(u'-', 0, -2) : text;
    for (int id = 0; id <= QPageSize::LastPageSize; ++id) {
        const auto size = QPageSize::PageSizeId(id);
        if (QPageSize::key(size).compare(name, Qt::CaseInsensitive) != 0)
            continue;
        const QSizeF paper = QPageSize::size(size, QPageSize::Millimeter);
        plan.sheet =
            landscape ? Point(paper.height(), paper.width()) : Point(paper.width(), paper.height());
        return !paper.isEmpty();
    }
    return false;
}

void refuseWithoutTiles(const ParsedArguments& arguments)
{
    for (const char* option : {"overlap", "sheet-margin", "marks"})
        if (arguments.has(QString::fromLatin1(option)))
            throw WrongUsage{Commands::tr("--%1 needs --tiles.").arg(QLatin1StringView(option))};
}

QStringList sheetNames(const Sheets& sheets, const Output& output)
{
    if (!namesEverySheet(output.path, sheets.tiling))
        return {output.path};
    const auto& tiles = sheets.tiling.tiles;
    return {sheetName(output.path, sheets.tiling, tiles.front()),
            sheetName(output.path, sheets.tiling, tiles.back())};
}

} // namespace

std::vector<Option> tileOptions()
{
    return {
        {{optionName},
         "COLUMNSxROWS|PAPER",
         Commands::tr(
             "Divide the page among sheets: so many of equal size, or sheets of this paper "
             "(a4, a3, letter …; a4-landscape). The name of the output holds {row} and "
             "{column}, or {n}; a PDF file without them gets a page for each sheet.")},
        {{"overlap"},
         "LENGTH",
         Commands::tr("The strip that neighbouring sheets have in common (0).")},
        {{"sheet-margin"},
         "LENGTH",
         Commands::tr("The margin of each sheet (10mm; 0 for COLUMNSxROWS without --marks).")},
        {{"marks"},
         {},
         Commands::tr("Draw registration marks, corner lines and a label in the margins.")},
    };
}

std::optional<TilePlan> tilePlanOf(const ParsedArguments& arguments, const Page& page)
{
    const auto text = arguments.text(optionName);
    if (!text) {
        refuseWithoutTiles(arguments);
        return std::nullopt;
    }
    TilePlan plan;
    plan.marks = arguments.has(QStringLiteral("marks"));
    const bool byNumber = takeNumbers(*text, plan);
    if (!byNumber && !takePaper(*text, plan))
        refuse({optionName, *text},
               Commands::tr("columns and rows such as 3x2, or a paper such as a4 or a4-landscape"));
    const double usual = byNumber && !plan.marks ? 0 : plan.margin;
    plan.margin = millimetres(arguments, QStringLiteral("sheet-margin"), usual, page);
    plan.overlap = millimetres(arguments, QStringLiteral("overlap"), 0, page);
    return plan;
}

void writeTiles(const TilePlan& plan, const Document& drawing, const CutOptions& options,
                const Output& output, const QString& input)
{
    auto tiling = tilingOf(drawing.page(), plan);
    if (!tiling)
        throw WrongUsage{tiling.error};
    const Sheets sheets{drawing, plan, *tiling.value, options, QFileInfo(input).completeBaseName()};
    if (output.path == QLatin1StringView("-"))
        throw WrongUsage{Commands::tr("--tiles writes files: name them with -o.")};
    if (const auto error = writeSheets(sheets, output.path, *output.format, output.options))
        throw Failure{*error};
    say(Commands::tr("Sheets: %1 columns × %2 rows of %3 × %4 mm: %5.")
            .arg(tiling.value->columns)
            .arg(tiling.value->rows)
            .arg(numberText(tiling.value->sheet.x, 1), numberText(tiling.value->sheet.y, 1),
                 sheetNames(sheets, output).join(QStringLiteral(" … "))));
}

} // namespace app
