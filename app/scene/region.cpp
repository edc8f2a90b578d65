// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/region.h"

#include "app/document/flatten.h"
#include "app/document/window_outline.h"
#include "app/scene/area_windows.h"
#include "clipping/region/box_part.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace app {

namespace {

/// How much of a box a set of points contains.
enum class Share : std::uint8_t { None, All, Some };

Share shareOf(clipping::BoxPart part)
{
    return part == clipping::BoxPart::None    ? Share::None
           : part == clipping::BoxPart::Whole ? Share::All
                                              : Share::Some;
}

Share shareIn(const ClipRegion::Step& step, const clipping::Window& box)
{
    const clipping::Window& window = step.box;
    if (!isProper(window) || box.max.x < window.min.x || box.min.x > window.max.x
        || box.max.y < window.min.y || box.min.y > window.max.y)
        return Share::None;
    if (!step.rings.empty())
        return step.area ? shareOf(clipping::partOf(box, step.area->prepared())) : Share::Some;
    const bool all = box.min.x >= window.min.x && box.max.x <= window.max.x
                     && box.min.y >= window.min.y && box.max.y <= window.max.y;
    return all ? Share::All : Share::Some;
}

Share opposite(Share share)
{
    return share == Share::None ? Share::All : share == Share::All ? Share::None : Share::Some;
}

Keep opposite(Keep keep) { return keep == Keep::Inside ? Keep::Outside : Keep::Inside; }

Share either(Share a, Share b)
{
    if (a == Share::All || b == Share::All)
        return Share::All;
    return a == Share::None && b == Share::None ? Share::None : Share::Some;
}

Share both(Share a, Share b) { return opposite(either(opposite(a), opposite(b))); }

Share shareAfter(WindowOperation operation, Share before, Share window)
{
    if (operation == WindowOperation::Add)
        return either(before, window);
    return both(before, operation == WindowOperation::CutOut ? opposite(window) : window);
}

bool hasArea(const clipping::Window& box) { return box.min.x < box.max.x && box.min.y < box.max.y; }

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr clipping::Window nothing{{infinite, infinite}, {-infinite, -infinite}};

clipping::Window boundsAround(const std::vector<std::vector<Point>>& rings)
{
    clipping::Window box = nothing;
    for (const auto& ring : rings)
        for (const Point& corner : ring)
            box = {glm::min(box.min, corner), glm::max(box.max, corner)};
    return box;
}

/// Moves the corners of a polygon away from the centre, until its edges are outside the curves of
/// its ellipse.
void moveAround(const EllipseRecipe& ellipse, std::vector<Point>& ring)
{
    const auto radiusOf = [&](const Point& p) {
        return glm::length(turnedBy(p - ellipse.centre, -ellipse.turn)
                           / glm::abs(ellipse.radii)); // 1 on the ellipse
    };
    double least = 1; // of an edge's middle, as a part of its ends'
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
        least = std::min(least, 2 * radiusOf((a + b) * 0.5) / (radiusOf(a) + radiusOf(b)));
    }
    if (!(least > 0.5)) // of a point, or a line
        return;
    // In the middle, the curve's radius is not quite the mean of those at the ends.
    constexpr double between = 1e-6;
    for (Point& corner : ring)
        corner = ellipse.centre + (corner - ellipse.centre) * ((1 + between) / least);
}

/// The outline of a shape for a cut, and for the screen.
struct Outlines {
    double tolerance;
    /// Objects' curves have chords on the screen, no farther than this from them; 0 for a cut.
    double drawn = 0;

    /// An object on the border of a window of its shape has the same chords; only the smooth
    /// polygon of an ellipse, whose object may begin elsewhere, lies around them.
    WindowOutline of(const WindowShape& shape) const
    {
        if (drawn == 0)
            return outlineOf(shape, tolerance);
        const EllipseRecipe* ellipse = ellipseOf(shape);
        WindowOutline outline = drawnOutlineOf(shape, ellipse ? tolerance : drawn);
        if (ellipse)
            for (auto& ring : outline.rings)
                moveAround(*ellipse, ring);
        return outline;
    }
};

ClipRegion::Step stepOf(const ClipWindow& window, const Outlines& outlines)
{
    const auto* rectangle = std::get_if<RectangleShape>(&window.shape);
    if (rectangle && !hasArea(rectangle->box))
        return {nothing, window.operation};
    if (const auto box = axisAlignedBox(window.shape))
        return {*box, window.operation};
    WindowOutline outline = outlines.of(window.shape);
    ClipRegion::Step step{boundsAround(outline.rings), window.operation, std::move(outline.rings),
                          outline.rule};
    step.polygon = convexPolygonOf(step.rings);
    step.area = std::make_shared<const LaterRegion>(
        clipping::Region{{{areaOf(step)}}, clipping::Keep::Inside});
    if (rectangle && !step.polygon.corners.empty())
        step.turned = clipping::turned(rectangle->box, rectangle->angle * 180 / std::numbers::pi);
    return step;
}

void prepare(ClipRegion& region)
{
    if (region.everything() || region.single())
        return;
    region.prepared = laterRegion(region, region.keep);
    region.opposite = laterRegion(region, opposite(region.keep));
}

ClipRegion regionOf(const ClipWindows& windows, const Outlines& outlines)
{
    ClipRegion region{{}, windows.keep};
    const ClipWindows counting = inEffect(windows);
    for (const ClipWindow& window : counting.list)
        region.steps.push_back(stepOf(window, outlines));
    prepare(region);
    return region;
}

} // namespace

std::optional<clipping::Window> ClipRegion::single() const
{
    if (steps.size() != 1 || !steps.front().rings.empty()
        || steps.front().operation == WindowOperation::CutOut)
        return std::nullopt;
    return steps.front().box;
}

ClipRegion regionOf(const ClipWindows& windows, double tolerance)
{
    return regionOf(windows, Outlines{tolerance});
}

ClipRegion regionOf(const ClipWindows& windows, const Page& page)
{
    return regionOf(windows, windowMillimetres / page.millimetresPerUnit());
}

ClipRegion shownRegionOf(const ClipWindows& windows, const Page& page)
{
    return regionOf(windows,
                    Outlines{windowMillimetres / page.millimetresPerUnit(), usualTolerance(page)});
}

ClipRegion withKeep(ClipRegion region, Keep keep)
{
    if (region.keep == keep)
        return region;
    region.keep = keep;
    std::swap(region.prepared, region.opposite);
    if (!region.prepared)
        prepare(region);
    return region;
}

Remains remainsOf(const ClipRegion& region, const clipping::Window& box)
{
    if (region.everything())
        return Remains::Whole;
    if (!isProper(box))
        return Remains::Pieces;
    Share share = region.startsFull() ? Share::All : Share::None;
    for (const ClipRegion::Step& step : region.steps) {
        const bool flat = !region.single() && !hasArea(step.box);
        share = shareAfter(step.operation, share, flat ? Share::None : shareIn(step, box));
    }
    if (share == Share::Some)
        return Remains::Pieces;
    return (share == Share::All) == (region.keep == Keep::Inside) ? Remains::Whole : Remains::Gone;
}

} // namespace app
