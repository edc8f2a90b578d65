// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/area_at.h"

#include "app/document/window_outline.h"
#include "app/view/block_grid.h"

#include <algorithm>

namespace app {
namespace {

class AreaSearch {
public:
    AreaSearch(const Document& document, const SceneLines& lines, const Point& point)
        : document_(document), lines_(lines), p_(point)
    {
    }

    std::optional<std::size_t> uppermost() const
    {
        for (std::size_t run = lines_.runs().size(); run-- > 0;)
            for (std::size_t chunk = lines_.blocks()[run]->chunks.size(); chunk-- > 0;)
                if (const auto object = uppermost(run, chunk))
                    return object;
        return std::nullopt;
    }

private:
    // The topmost hit among the objects that begin in the chunk. Only the last of them can have
    // lines in other chunks.
    std::optional<std::size_t> uppermost(std::size_t run, std::size_t at) const
    {
        const SceneBlock& block = *lines_.blocks()[run];
        const SceneChunk& chunk = block.chunks[at];
        const Style& style = document_.styles()[chunk.style];
        if (!style.fill)
            return std::nullopt;
        const std::size_t end = block.endOfChunk(at);
        const bool all = !isOutside(chunk.box, {p_, p_});
        for (std::size_t line = end; line > chunk.first;) {
            const std::size_t object = block.objectOf(line - 1);
            const bool last = line == end;
            line = block.firstOf(object);
            if (line < chunk.first || (object == 0 && block.continues))
                break;
            const std::size_t number = lines_.runs()[run].firstObject + object;
            if ((all || (last && isAround(number))) && contains(number, style.fillRule)
                && document_.editable(number))
                return number;
            if (!all)
                break;
        }
        return std::nullopt;
    }

    template <class Visit>
    void forEachPart(std::size_t object, const Visit& visit) const
    {
        lines_.forEachPart(lines_.firstLineOf(object), lines_.firstLineOf(object + 1), visit);
    }

    bool isAround(std::size_t object) const
    {
        std::optional<FloatBox> box;
        forEachPart(object, [&](std::size_t run, std::size_t first, std::size_t end) {
            const SceneBlock& block = *lines_.blocks()[run];
            for (std::size_t chunk = block.chunkOf(first); first < end; ++chunk) {
                const FloatBox& here = block.chunks[chunk].box;
                box = box ? united(*box, here) : here;
                first = block.endOfChunk(chunk);
            }
        });
        return box && !isOutside(*box, {p_, p_});
    }

    bool contains(std::size_t object, FillRule rule) const
    {
        Crossings crossings(p_);
        forEachPart(object, [&](std::size_t run, std::size_t first, std::size_t end) {
            for (; first < end; ++first)
                crossings.add(lines_.runs()[run].segments[first]);
        });
        crossings.close();
        return crossings.inside(rule);
    }

    const Document& document_;
    const SceneLines& lines_;
    Point p_;
};

} // namespace

std::optional<std::size_t> areaAt(const Document& document, const SceneLines& lines,
                                  const Point& point)
{
    return AreaSearch(document, lines, point).uppermost();
}

namespace {

enum class Hit : std::uint8_t { Beside, Border, Inside };

Hit hitOf(const WindowShape& shape, const Point& point, double reach)
{
    const WindowOutline outline = outlineOf(shape, std::max(reach / 4, 1e-12));
    Crossings crossings(point);
    for (const auto& ring : outline.rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const clipping::Segment edge{ring[i], ring[(i + 1) % ring.size()]};
            if (distance(point, edge) <= reach)
                return Hit::Border;
            crossings.add(edge);
        }
        crossings.close();
    }
    return crossings.inside(outline.rule) ? Hit::Inside : Hit::Beside;
}

template <class IsHit>
std::optional<std::size_t> lastVisible(const ClipWindows& windows, const IsHit& isHit)
{
    for (std::size_t i = windows.list.size(); i-- > 0;)
        if (windows.list[i].visible && isHit(windows.list[i].shape))
            return i;
    return std::nullopt;
}

} // namespace

bool isAt(const WindowShape& shape, const Point& point, double reach)
{
    return hitOf(shape, point, reach) != Hit::Beside;
}

std::optional<std::size_t> windowBorderAt(const ClipWindows& windows, const Point& point,
                                          double reach)
{
    return lastVisible(windows, [&](const WindowShape& shape) {
        return hitOf(shape, point, reach) == Hit::Border;
    });
}

std::optional<std::size_t> windowAt(const ClipWindows& windows, const Point& point, double reach)
{
    return lastVisible(windows,
                       [&](const WindowShape& shape) { return isAt(shape, point, reach); });
}

} // namespace app
