// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/tile_options.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/command_line/command.h"
#include "app/command_line/terminal.h"
#include "app/scene/bounds.h"
#include "app/tiles/empty_sheets.h"
#include "app/tiles/sheet_names.h"
#include "app/tiles/sheet_settings.h"
#include "app/tiles/sheets.h"

#include <QFileInfo>
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

// "45mmx48mm", or "45x48mm": a width and a height.
bool takeSize(const QString& text, TilePlan& plan)
{
    const qsizetype by = text.lastIndexOf(QRegularExpression(QStringLiteral("[x×](?=[0-9.])")));
    if (by < 0)
        return false;
    const auto height = parseLength(text.sliced(by + 1).toStdString());
    auto width = parseLength(text.first(by).toStdString());
    if (width && height && width->unit == Unit::User)
        width->unit = height->unit;
    const auto millimetres = [](const std::optional<Length>& length) {
        return length ? length->value * infoOf(length->unit).millimetres : 0;
    };
    plan.sheet = {millimetres(width), millimetres(height)};
    return plan.sheet.x > 0 && plan.sheet.y > 0;
}

// "a4" or "a4-landscape": a size of paper.
bool takePaper(const QString& text, TilePlan& plan)
{
    const bool landscape = text.endsWith(QLatin1StringView("-landscape"));
    const auto paper = paperSize(landscape ? text.section(u'-', 0, -2) : text);
    if (paper)
        plan.sheet = landscape ? Point(paper->y, paper->x) : *paper;
    return paper.has_value();
}

// "150%" or "1.5".
double scaleOf(const ParsedArguments& arguments)
{
    const QString option = QStringLiteral("scale");
    const auto text = arguments.text(option);
    if (!text)
        return 1;
    const auto given = parseLength(text->toStdString());
    const bool percent = given && given->unit == Unit::Percent;
    const double scale = !given ? 0 : percent ? given->value / 100 : given->value;
    if (!(scale > 0) || (!percent && given->unit != Unit::User))
        refuse({option, *text},
               Text::tr("a positive percentage such as 150%, or a factor such as 1.5"));
    return scale;
}

void refuseWithoutTiles(const ParsedArguments& arguments)
{
    for (const char* option :
         {"overlap", "sheet-margin", "marks", "scale", "overview", "empty-sheets"})
        if (arguments.has(QString::fromLatin1(option)))
            throw WrongUsage{Text::tr("--%1 needs --tiles.").arg(QLatin1StringView(option))};
}

Tiling tilingOf(const TilePlan& plan, const Document& drawing, const CutOptions& options)
{
    const SceneLines lines =
        linesOf(drawing.objects(), drawing.containers().hiddenRanges(), options.tolerance);
    const auto tiling = tilingOf(drawing.page(), plan, boundsOf(lines));
    if (!tiling)
        throw WrongUsage{tiling.error};
    return withoutEmptySheets(*tiling.value, plan, lines, drawing.objects(), options.leastLength);
}

// "a.svg", or the first and the last file.
QString filesText(const QStringList& files)
{
    return files.size() == 1 ? files.front() : files.front() + QStringLiteral(" … ") + files.back();
}

} // namespace

std::vector<Option> tileOptions()
{
    return {
        {{optionName},
         "COLUMNSxROWS|SIZE|PAPER",
         Text::tr("Divide the page among sheets. COLUMNSxROWS: so many of equal size, columns "
                  "first: 3x2 makes 3 columns side by side in 2 rows, 6 sheets. SIZE: as many "
                  "sheets of this width and height as are needed, with their units (45mmx48mm). "
                  "PAPER: the same with a size of paper (a4, a3, letter …; a4-landscape). The name "
                  "of the output holds {row} and {column}, or {n}, which counts row by row. A PDF "
                  "file without them gets a page for each sheet. Whole sheets are added for what "
                  "lies beyond the page.")},
        {{"overlap"}, "LENGTH", Text::tr("The strip that neighbouring sheets have in common (0).")},
        {{"sheet-margin"},
         "LENGTH",
         Text::tr("The margin of each sheet (10mm for PAPER, or with --marks; otherwise 0).")},
        {{"marks"},
         {},
         Text::tr("Draw registration marks, corner lines and a label in the margins.")},
        {{"scale"},
         "PERCENT",
         Text::tr("The size of the drawing on the sheets: 200% is twice as large, strokes "
                  "included (100%). Overlap and margin are lengths on paper.")},
        {{"overview"},
         {},
         Text::tr("Add a sheet with the whole drawing, the edges of all sheets and their numbers. "
                  "It is the first page of a PDF file, or a file with “overview” in place of {row} "
                  "and {column}.")},
        {{"empty-sheets"},
         {},
         Text::tr("Write sheets without any part of the drawing, too (they are left out).")},
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
    plan.marks = arguments.has(QStringLiteral("marks")) ? allMarks : SheetMarks{};
    plan.scale = scaleOf(arguments);
    if (arguments.has(QStringLiteral("empty-sheets")))
        plan.empty = EmptySheets::Written;
    const bool isPaper = takePaper(*text, plan);
    if (!isPaper && !takeNumbers(*text, plan) && !takeSize(*text, plan))
        refuse({optionName, *text},
               Text::tr("columns and rows such as 3x2, a size such as 45mmx48mm, or a paper "
                        "such as a4 or a4-landscape"));
    const double usual = isPaper || plan.marks.any() ? plan.margin : 0;
    plan.margin = millimetres(arguments, QStringLiteral("sheet-margin"), usual, page);
    plan.overlap = millimetres(arguments, QStringLiteral("overlap"), 0, page);
    return plan;
}

void writeTiles(const ParsedArguments& arguments, const TilePlan& plan, const Document& drawing,
                const CutOptions& options, const Output& output)
{
    const Sheets sheets{drawing,
                        plan,
                        tilingOf(plan, drawing, options),
                        options,
                        QFileInfo(arguments.operands().first()).completeBaseName(),
                        arguments.has(QStringLiteral("overview")) ? OverviewSheet::Yes
                                                                  : OverviewSheet::No};
    if (output.path == QLatin1StringView("-"))
        throw WrongUsage{Text::tr("--tiles writes files: name them with -o.")};
    if (sheets.tiling.written() == 0)
        throw Failure{Text::tr("All sheets are empty. --empty-sheets writes them.")};
    if (const auto error = writeSheets(sheets, output.path, *output.format, output.options))
        throw Failure{*error};
    say(Text::tr("Sheets: %1 of %2 × %3 mm: %4.")
            .arg(gridText(sheets.tiling), numberText(sheets.tiling.sheet.x, 1),
                 numberText(sheets.tiling.sheet.y, 1), filesText(filesOf(sheets, output.path))));
    if (const QString beyond = beyondText(sheets.tiling); !beyond.isEmpty())
        say(beyond);
    if (const QString empty = emptySheetsText(sheets.tiling); !empty.isEmpty())
        say(empty + u' ' + Text::tr("--empty-sheets writes them."));
}

} // namespace app
