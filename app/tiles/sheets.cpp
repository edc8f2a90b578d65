// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tiles/sheets.h"

#include "app/base/replace_file.h"
#include "app/base/text.h"
#include "app/base/unfinished.h"
#include "app/cut/fresh_ids.h"
#include "app/formats/pdf/writer.h"
#include "app/tiles/marks.h"
#include "app/tiles/overview.h"

#include <QElapsedTimer>

#include <algorithm>

namespace app {
namespace {

void addMarks(Document& sheet, const std::vector<Object>& marks)
{
    auto [tree, layer] = withLayerAbove(sheet, Text::tr("Sheet marks"));
    sheet.apply({.containers = std::move(tree)});
    Objects objects = sheet.objects().slice(0, 0);
    for (const Object& mark : marks)
        objects.append(mark);
    sheet.apply(adding(sheet, objects, layer));
}

/// A page to be written; null: the overview.
using Pages = std::vector<const Tile*>;

Pages pagesOf(const Sheets& sheets)
{
    Pages pages;
    if (sheets.overview == OverviewSheet::Yes)
        pages.push_back(nullptr);
    for (const Tile& tile : sheets.tiling.tiles)
        if (!tile.leftOut)
            pages.push_back(&tile);
    return pages;
}

Document pageOf(const Sheets& sheets, const Tile* tile)
{
    return tile ? sheets.sheet(*tile) : overviewOf(sheets);
}

QString nameOf(const Sheets& sheets, const QString& pattern, const Tile* tile)
{
    return tile ? sheetName(pattern, sheets.tiling, *tile) : overviewName(pattern);
}

/// Tells the follower how many of the pages are done.
class Advance {
public:
    Advance(const Follower& follower, std::size_t pages) : follower_(follower), pages_(pages)
    {
        clock_.start();
    }
    void done(std::size_t pages) const
    {
        if (!follower_.progress || pages == 0)
            return;
        const double share = double(pages) / double(pages_);
        follower_.progress({share, double(clock_.elapsed()) * 1e-3 * (1 / share - 1)});
    }

private:
    const Follower& follower_;
    std::size_t pages_;
    QElapsedTimer clock_;
};

QString cancelled(std::size_t done, std::size_t all)
{
    return Text::tr("The export was cancelled after %1 of %2 sheets.").arg(done).arg(all);
}

std::optional<QString> writePages(const Sheets& sheets, const QString& path,
                                  const WriteOptions& options, const Follower& follower)
{
    const Pages pages = pagesOf(sheets);
    const Advance advance(follower, pages.size());
    const Unfinished guard(path);
    const auto error = replaceFile(path, [&](QIODevice& out) -> std::optional<QString> {
        const auto failed = pdf::writePages(
            pages.size(),
            [&](std::size_t number) {
                advance.done(number);
                // After a stop the rest need not be right: the file is not kept.
                return follower.stop.stop_requested() ? Document() : pageOf(sheets, pages[number]);
            },
            out, options);
        return follower.stop.stop_requested() ? Text::tr("the export was cancelled.") : failed;
    });
    if (error && follower.stop.stop_requested())
        return Text::tr("The export was cancelled; %1 is as it was before.").arg(path);
    return error ? std::optional(Text::tr("Cannot write %1: %2").arg(path, *error)) : std::nullopt;
}

} // namespace

std::size_t Sheets::count() const { return pagesOf(*this).size(); }

Document Sheets::sheet(const Tile& tile) const
{
    const double unit = tiling.millimetresPerUnit;
    CutOptions cutting = options;
    cutting.region = {{{tile.window, WindowOperation::Add}}};
    cutting.windows = {};
    Document made = withOwnStyles(drawing);
    Edit edit = cut(made, cutting).edit;
    edit.windows = ClipWindows();
    edit.page = Page{tile.window.min - plan.margin / unit,
                     tiling.sheet / unit,
                     {tiling.sheet.x, Unit::Mm},
                     {tiling.sheet.y, Unit::Mm}};
    edit.page->scale = drawing.page().scale;
    if (drawing.page().scale.ratio != 1)
        edit.page->scale.ratio /= plan.scale; // the drawing is enlarged for its sheets
    made.apply(edit);
    if (plan.marks.any())
        addMarks(made, marksOf(tiling, tile, plan, title));
    return made;
}

QStringList filesOf(const Sheets& sheets, const QString& pattern)
{
    if (!namesEverySheet(pattern, sheets.tiling))
        return {pattern};
    QStringList files;
    for (const Tile* tile : pagesOf(sheets))
        files << nameOf(sheets, pattern, tile);
    return files;
}

std::optional<QString> writeSheets(const Sheets& sheets, const QString& pattern,
                                   const Format& format, const WriteOptions& options,
                                   const Follower& follower)
{
    if (!namesEverySheet(pattern, sheets.tiling)) {
        if (format.key == "pdf")
            return writePages(sheets, pattern, options, follower);
        return Text::tr(
                   "%1 is one name for %2 sheets. Put {row} and {column}, or {n}, into it; only a "
                   "PDF file holds them all.")
            .arg(pattern)
            .arg(sheets.count());
    }
    const Pages pages = pagesOf(sheets);
    const Advance advance(follower, pages.size());
    for (std::size_t number = 0; number < pages.size(); ++number) {
        if (follower.stop.stop_requested())
            return cancelled(number, pages.size());
        const Tile* tile = pages[number];
        const QString path = nameOf(sheets, pattern, tile);
        const Unfinished guard(path);
        WriteOptions of = options;
        of.stop = follower.stop;
        of.sources.clear(); // they number the objects of the whole drawing
        of.bounds.reset();  // marks are outside
        if (tile && !sheets.plan.marks.any())
            of.bounds = tile->window;
        const auto error = writeFile(pageOf(sheets, tile), path, of, &format);
        if (error && follower.stop.stop_requested())
            return cancelled(number, pages.size());
        if (error)
            return error;
        advance.done(number + 1);
    }
    return std::nullopt;
}

} // namespace app
