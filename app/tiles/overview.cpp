// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tiles/overview.h"

#include "app/base/text.h"
#include "app/cut/fresh_ids.h"
#include "app/lettering/lettering.h"
#include "app/lettering/stroke_fonts.h"

#include <algorithm>

namespace app {
namespace {

constexpr double thinLine = 0.35, tallest = 12; // millimetres on the overview

/// Lines of one width in millimetres.
class Grid {
public:
    explicit Grid(double millimetresPerUnit) : unit_(1 / millimetresPerUnit)
    {
        style_.stroke = Colour{};
        style_.width = thinLine * unit_;
    }

    void addEdges(const clipping::Window& w)
    {
        const Subpath edges{
            w.min, {{Point(w.max.x, w.min.y)}, {w.max}, {Point(w.min.x, w.max.y)}}, true};
        add({edges});
    }

    // In the middle, as large as fits.
    void addNumber(const Tile& tile)
    {
        const QString text = QStringLiteral("%1-%2").arg(tile.row).arg(tile.column);
        const Point room = tile.window.max - tile.window.min;
        const double size =
            std::min({room.y * 0.4, room.x * 0.8 / double(text.size()), tallest * unit_});
        std::vector<Subpath> letters =
            lettered({text, strokeFonts().front().name, size, tile.window.min}).paths;
        const clipping::Window box = boundsOf(letters);
        const Point to = (tile.window.min + tile.window.max - box.min - box.max) * 0.5;
        for (Subpath& stroke : letters) {
            stroke.start += to;
            for (PathSegment& segment : stroke.segments) {
                segment.to += to;
                segment.control1 += to;
                segment.control2 += to;
            }
        }
        add(letters);
    }

    std::vector<Object> objects{};

private:
    static clipping::Window boundsOf(const std::vector<Subpath>& strokes)
    {
        clipping::Window box{strokes.front().start, strokes.front().start};
        const auto include = [&box](const Point& p) {
            box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
            box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
        };
        for (const Subpath& stroke : strokes) {
            include(stroke.start);
            for (const PathSegment& segment : stroke.segments)
                include(segment.to);
        }
        return box;
    }
    void add(const std::vector<Subpath>& paths)
    {
        objects.push_back({.path = Path(paths), .style = style_});
    }

    double unit_; // user units in a millimetre
    Style style_;
};

} // namespace

Document overviewOf(const Sheets& sheets)
{
    const Tiling& tiling = sheets.tiling;
    const clipping::Window whole = tiling.whole();
    const Point extent = whole.max - whole.min;
    const Point room = tiling.sheet - 2 * std::max(sheets.plan.margin, leastMarkedMargin);
    const double millimetresPerUnit = std::min(room.x / extent.x, room.y / extent.y);
    const Point size = tiling.sheet / millimetresPerUnit;

    Document made = withOwnStyles(sheets.drawing);
    auto [tree, layer] = withLayerAbove(made, Text::tr("Sheet numbers"));
    made.apply({.containers = std::move(tree),
                .windows = ClipWindows(),
                .page = Page{(whole.min + whole.max - size) * 0.5,
                             size,
                             {tiling.sheet.x, Unit::Mm},
                             {tiling.sheet.y, Unit::Mm}}});
    Grid grid(millimetresPerUnit);
    for (const Tile& tile : tiling.tiles) {
        grid.addEdges(tile.window);
        if (!tile.leftOut)
            grid.addNumber(tile);
    }
    Objects objects = made.objects().slice(0, 0);
    for (const Object& object : grid.objects)
        objects.append(object);
    made.apply(adding(made, objects, layer));
    return made;
}

} // namespace app
