// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tiles/empty_sheets.h"

#include "app/base/text.h"
#include "app/base/variant.h"
#include "app/view/area_at.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

using clipping::Segment;
using clipping::Window;

/// The columns or rows [first, end) that may contain a part of [low, high].
struct Span {
    int first, end;
};

class Search {
public:
    Search(Tiling& tiling, double leastLength)
        : tiling_(tiling), leastLength_(leastLength), left_(tiling.tiles.size())
    {
        for (Tile& tile : tiling_.tiles)
            tile.empty = true;
    }

    bool isDone() const { return left_ == 0; } ///< no sheet is empty

    void add(const Segment& line)
    {
        const auto [low, high] = std::pair(glm::min(line.a, line.b), glm::max(line.a, line.b));
        forEachTile(low, high, [&](Tile& tile) {
            if (keepsPart(line, tile.window))
                fill(tile);
        });
    }

    // An area is closed, also where its lines are open. Then no line of it is on an empty sheet, so
    // all of the sheet is inside or outside.
    void addArea(std::span<const Subpath> paths, std::vector<Segment> lines, FillRule rule)
    {
        if (lines.empty())
            return;
        for (const Subpath& path : paths)
            if (!path.closed && !path.segments.empty()) {
                lines.push_back({path.segments.back().to, path.start});
                add(lines.back());
            }
        Point low = lines.front().a, high = low;
        for (const Segment& line : lines) {
            low = glm::min(low, glm::min(line.a, line.b));
            high = glm::max(high, glm::max(line.a, line.b));
        }
        forEachTile(low, high, [&](Tile& tile) {
            Crossings crossings((tile.window.min + tile.window.max) * 0.5);
            for (const Segment& line : lines)
                crossings.count(line);
            if (crossings.inside(rule))
                fill(tile);
        });
    }

private:
    Span spanOf(int axis, double low, double high) const
    {
        const Window& first = tiling_.tiles.front().window;
        const int count = axis == 0 ? tiling_.columns : tiling_.rows;
        const double size = first.max[axis] - first.min[axis];
        const double step = size - tiling_.overlap;
        const auto index = [&](double at) {
            return int(std::clamp(std::floor((at - first.min[axis]) / step), -1.0, double(count)));
        };
        // One more at each end, for rounding.
        const int back = int(std::ceil(size / step)) + 1;
        return {std::clamp(index(low) - back, 0, count), std::clamp(index(high) + 2, 0, count)};
    }

    template <class Visit>
    void forEachTile(const Point& low, const Point& high, const Visit& visit)
    {
        const Span columns = spanOf(0, low.x, high.x), rows = spanOf(1, low.y, high.y);
        for (int row = rows.first; row < rows.end; ++row)
            for (int column = columns.first; column < columns.end; ++column)
                if (Tile& tile = tiling_.tiles[std::size_t(row * tiling_.columns + column)];
                    tile.empty)
                    visit(tile);
    }

    bool keepsPart(const Segment& line, const Window& window) const
    {
        const auto piece = usualAlgorithm().corrected.clip(line, window);
        if (!piece || *piece == line)
            return piece.has_value();
        const Point way = piece->b - piece->a;
        const double length = std::hypot(way.x, way.y);
        return length > 0 && length >= leastLength_;
    }

    void fill(Tile& tile)
    {
        tile.empty = false;
        --left_;
    }

    Tiling& tiling_;
    double leastLength_;
    std::size_t left_; ///< sheets that are empty so far
};

} // namespace

Tiling withoutEmptySheets(Tiling tiling, const TilePlan& plan, const SceneLines& lines,
                          const Objects& objects, double leastLength)
{
    if (plan.empty == EmptySheets::Written)
        return tiling;
    Search search(tiling, leastLength);
    for (const SceneLines::Run& run : lines.runs())
        for (std::size_t i = 0; i < run.segments.size() && !search.isDone(); ++i)
            search.add(run.segments[i]);
    std::vector<Segment> outline;
    for (std::size_t object = 0; object < objects.size() && !search.isDone(); ++object) {
        const ObjectView view = objects[object];
        if (!view.style().fill)
            continue;
        outline.clear();
        for (std::size_t i = lines.firstLineOf(object); i < lines.firstLineOf(object + 1); ++i)
            outline.push_back(lines[i]);
        search.addArea(view.path().subpaths(), outline, view.style().fillRule);
    }
    for (Tile& tile : tiling.tiles)
        tile.leftOut = tile.leftOut || tile.empty;
    return tiling;
}

QString emptySheetsText(const Tiling& tiling)
{
    const auto count = std::ranges::count(tiling.tiles, true, &Tile::empty);
    return count == 0   ? QString()
           : count == 1 ? Text::tr("1 empty sheet was left out.")
                        : Text::tr("%1 empty sheets were left out.").arg(count);
}

} // namespace app
