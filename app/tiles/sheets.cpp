// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tiles/sheets.h"

#include "app/base/replace_file.h"
#include "app/base/unfinished.h"
#include "app/cut/layer_above.h"
#include "app/formats/pdf/writer.h"
#include "app/tiles/marks.h"

#include <QCoreApplication>

namespace app {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("Tiles", text); }

void addMarks(Document& sheet, const std::vector<Object>& marks)
{
    auto [tree, layer] = withLayerAbove(sheet, tr("Sheet marks"));
    sheet.apply({.containers = std::move(tree)});
    Objects objects = sheet.objects().slice(0, 0);
    for (const Object& mark : marks)
        objects.append(mark);
    sheet.apply(adding(sheet, objects, layer));
}

std::optional<QString> writePages(const Sheets& sheets, const QString& path,
                                  const WriteOptions& options)
{
    const Unfinished guard(path);
    const auto error = replaceFile(path, [&](QIODevice& out) {
        return pdf::writePages(
            sheets.count(), [&](std::size_t number) { return sheets.sheet(number); }, out, options);
    });
    return error ? std::optional(tr("Cannot write %1: %2").arg(path, *error)) : std::nullopt;
}

} // namespace

Document Sheets::sheet(std::size_t number) const
{
    const Tile& tile = tiling.tiles[number];
    const double unit = drawing.page().millimetresPerUnit();
    CutOptions cutting = options;
    cutting.region = {{{tile.window, WindowOperation::Add}}};
    Document made = withOwnStyles(drawing);
    Edit edit = cut(made, cutting).edit;
    edit.windows = ClipWindows();
    edit.page = Page{tile.window.min - plan.margin / unit,
                     tiling.sheet / unit,
                     {tiling.sheet.x, Unit::Mm},
                     {tiling.sheet.y, Unit::Mm}};
    made.apply(edit);
    if (plan.marks)
        addMarks(made, marksOf(tiling, tile, plan.margin, unit, title));
    return made;
}

QString sheetName(const QString& pattern, const Tiling& tiling, const Tile& tile)
{
    QString name = pattern;
    const int number = (tile.row - 1) * tiling.columns + tile.column;
    return name.replace(QStringLiteral("{row}"), QString::number(tile.row))
        .replace(QStringLiteral("{column}"), QString::number(tile.column))
        .replace(QStringLiteral("{n}"), QString::number(number));
}

bool namesEverySheet(const QString& pattern, const Tiling& tiling)
{
    const auto has = [&](const char* word) { return pattern.contains(QLatin1StringView(word)); };
    return has("{n}")
           || ((tiling.rows == 1 || has("{row}")) && (tiling.columns == 1 || has("{column}")));
}

std::optional<QString> writeSheets(const Sheets& sheets, const QString& pattern,
                                   const Format& format, const WriteOptions& options)
{
    if (!namesEverySheet(pattern, sheets.tiling)) {
        if (format.key == "pdf")
            return writePages(sheets, pattern, options);
        return tr("%1 is one name for %2 sheets. Put {row} and {column}, or {n}, into it; only a "
                  "PDF file holds them all.")
            .arg(pattern)
            .arg(sheets.count());
    }
    for (std::size_t number = 0; number < sheets.count(); ++number) {
        const Tile& tile = sheets.tiling.tiles[number];
        const QString path = sheetName(pattern, sheets.tiling, tile);
        const Unfinished guard(path);
        WriteOptions of = options;
        of.bounds = tile.window;
        if (sheets.plan.marks)
            of.bounds.reset(); // marks are outside
        if (const auto error = writeFile(sheets.sheet(number), path, of, &format))
            return error;
        if (options.stop.stop_requested())
            return tr("The export was cancelled after %1 of %2 sheets.")
                .arg(number + 1)
                .arg(sheets.count());
    }
    return std::nullopt;
}

} // namespace app
