// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/print_job.h"

#include "app/base/replace_file.h"
#include "app/base/text.h"
#include "app/formats/paint_drawing.h"
#include "app/formats/painted.h"
#include "app/formats/pdf/writer.h"

#include <QPageLayout>
#include <QPageSize>
#include <QPagedPaintDevice>
#include <QPainter>

#include <utility>

namespace app {
namespace {

constexpr double rounding = 1e-6; // millimetres
constexpr double millimetresPerInch = 25.4;

TilePlan planOf(const PrintChoice& choice, bool landscape)
{
    TilePlan plan;
    plan.sheet = landscape ? Point(choice.paper.y, choice.paper.x) : choice.paper;
    plan.margin = choice.margin;
    plan.overlap = choice.overlap;
    if (choice.marks)
        plan.marks = allMarks;
    return plan;
}

bool fits(const Point& drawing, const Point& paper)
{
    return drawing.x <= paper.x + rounding && drawing.y <= paper.y + rounding;
}

/// One sheet of the size of the paper, with the drawing in its middle.
Tiling tilingOfOne(const Page& page, const Point& paper)
{
    const double unit = page.millimetresPerUnit();
    const Point middle = page.min + page.size * 0.5, half = paper / unit * 0.5;
    Tiling tiling{paper, 1, 1, {{1, 1, {middle - half, middle + half}}}, unit};
    tiling.drawing = page.size * unit;
    return tiling;
}

Result<PrintSheets> laidOn(const ExportDrawing& drawing, const PrintChoice& choice, bool landscape)
{
    PrintSheets made;
    made.sheets.drawing = drawing.document;
    made.sheets.plan = planOf(choice, landscape);
    const Page& page = drawing.document.page();
    if (fits(page.size * page.millimetresPerUnit(), made.sheets.plan.sheet)) {
        made.single = true;
        made.sheets.tiling = tilingOfOne(page, made.sheets.plan.sheet);
        return Result<PrintSheets>::of(std::move(made));
    }
    auto tiling = tilingOf(page, made.sheets.plan);
    if (!tiling)
        return Result<PrintSheets>::failure(tiling.error);
    made.sheets.tiling = std::move(*tiling.value);
    return Result<PrintSheets>::of(std::move(made));
}

QString cancelled() { return Text::tr("Printing was cancelled."); }

void tell(const Follower& follower, std::size_t done, std::size_t all)
{
    if (follower.progress)
        follower.progress({double(done) / double(all), 0});
}

} // namespace

Document PrintSheets::page(std::size_t number) const
{
    if (!single)
        return sheets.sheet(sheets.tiling.tiles.at(number));
    Document made = sheets.drawing;
    const clipping::Window& paper = sheets.tiling.tiles.front().window;
    made.apply({.page = Page{paper.min,
                             paper.max - paper.min,
                             {sheets.tiling.sheet.x, Unit::Mm},
                             {sheets.tiling.sheet.y, Unit::Mm}}});
    return made;
}

std::vector<clipping::Window> PrintSheets::papers() const
{
    const double margin = single ? 0 : sheets.plan.margin / sheets.tiling.millimetresPerUnit;
    std::vector<clipping::Window> papers;
    for (const Tile& tile : sheets.tiling.tiles)
        papers.push_back({tile.window.min - margin, tile.window.max + margin});
    return papers;
}

Result<PrintSheets> printSheets(const ExportDrawing& drawing, const PrintChoice& choice,
                                const ExportSource& source, const QString& title)
{
    if (!(choice.paper.x > 0 && choice.paper.y > 0))
        return Result<PrintSheets>::failure(Text::tr("The paper has no size. Choose another one."));
    auto portrait = laidOn(drawing, choice, false), landscape = laidOn(drawing, choice, true);
    const auto countOf = [](const Result<PrintSheets>& made) {
        return made ? made.value->count() : mostTiles + 1;
    };
    const bool turned =
        choice.turn == PaperTurn::Landscape
        || (choice.turn == PaperTurn::Automatic && countOf(landscape) < countOf(portrait));
    auto made = std::move(turned ? landscape : portrait);
    if (made) {
        made.value->sheets.options = exportOptions(source.cutting, drawing.document.page());
        made.value->sheets.options.clipAll = source.clipAll;
        made.value->sheets.title = title;
    }
    return made;
}

std::optional<QString> printFile(const PrintSheets& sheets, const QString& path,
                                 const Follower& follower)
{
    const auto count = std::size_t(sheets.count());
    const auto error = replaceFile(path, [&](QIODevice& out) -> std::optional<QString> {
        const auto failed = pdf::writePages(count,
                                            [&](std::size_t number) {
                                                tell(follower, number, count);
                                                // After a stop the rest need not be right: the file
                                                // is not kept.
                                                return follower.stop.stop_requested()
                                                           ? Document()
                                                           : sheets.page(number);
                                            },
                                            out, {});
        return follower.stop.stop_requested() ? cancelled() : failed;
    });
    if (error && follower.stop.stop_requested())
        return error;
    return error ? std::optional(Text::tr("Cannot write %1: %2").arg(path, *error)) : std::nullopt;
}

std::optional<QString> printOn(QPagedPaintDevice& device, const PrintSheets& sheets,
                               const Follower& follower)
{
    const auto failure = [] {
        return Text::tr("The printer did not take the drawing. See whether it is switched on and "
                        "has paper, and print again.");
    };
    const bool landscape = sheets.paper().x > sheets.paper().y;
    QSizeF paper(sheets.paper().x, sheets.paper().y);
    device.setPageSize(QPageSize(landscape ? paper.transposed() : paper, QPageSize::Millimeter));
    device.setPageOrientation(landscape ? QPageLayout::Landscape : QPageLayout::Portrait);
    device.setPageMargins({});
    QPainter painter;
    if (!painter.begin(&device))
        return failure();
    const auto count = std::size_t(sheets.count());
    for (std::size_t number = 0; number < count; ++number) {
        tell(follower, number, count);
        if (follower.stop.stop_requested())
            return cancelled();
        if (number > 0 && !device.newPage())
            return failure();
        const Document page = sheets.page(number);
        const double pixelsPerMillimetre = device.logicalDpiX() / millimetresPerInch;
        paintOn(painter, page, paperOf(page.page()).millimetresPerUnit * pixelsPerMillimetre,
                follower.stop);
    }
    return painter.end() ? std::nullopt : std::optional(failure());
}

} // namespace app
