// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/stroke_area.h"

#include "app/base/progress.h"
#include "app/cut/area_outline.h"
#include "app/cut/cut_edit.h"
#include "app/cut/dashed_path.h"
#include "app/cut/stroke_rings.h"

#include <glm/common.hpp>

#include <algorithm>

namespace app {
namespace {

/// One area instead of rings above each other.
std::vector<Subpath> united(const std::vector<Subpath>& rings, double tolerance,
                            const std::stop_token& stop)
{
    std::vector<Chord> chords;
    for (const Subpath& ring : rings)
        flatten(ring, tolerance, chords);
    if (chords.empty())
        return {};
    const FlatArea flat = flatAreaOf(rings, FillRule::NonZero, chords);
    clipping::Window box{flat.area.points[0], flat.area.points[0]};
    for (const Point& p : flat.area.points)
        box = {glm::min(box.min, p), glm::max(box.max, p)};
    const Point margin = box.max - box.min + 1.0;
    const auto [min, max] = clipping::Window{box.min - margin, box.max + margin};
    const clipping::Area around{{min, {max.x, min.y}, max, {min.x, max.y}}, {4}};
    auto clipped = clipping::clipArea(around, clipping::PreparedRegion({{{flat.area}}}), stop);
    // The area is the window here: the edges of all rings are its.
    for (clipping::EdgeOrigin& origin : clipped.origins)
        origin.isOfWindow = false;
    return subpathsOf(clipped, rings, flat, clipping::PreparedRegion({}), {});
}

constexpr double leastShare = 1e-6; // of what is drawn; otherwise curves would need too much memory

double sizeOf(const Path& path)
{
    std::optional<clipping::Window> box;
    path.forEachPoint([&](const Point& p) {
        box = box ? clipping::Window{glm::min(box->min, p), glm::max(box->max, p)}
                  : clipping::Window{p, p};
    });
    return box ? std::max(box->max.x - box->min.x, box->max.y - box->min.y) : 0;
}

std::vector<Object> outlined(const Object& object, std::vector<Subpath> stroke)
{
    std::vector<Object> areas;
    if (object.style.fill && object.path.hasArea()) {
        areas.push_back(object);
        areas.back().style.stroke.reset();
    }
    Object area = object;
    area.path = Path(stroke);
    area.style = {.fill = object.style.stroke};
    area.particulars.recipe = {};
    areas.push_back(std::move(area));
    return areas;
}

std::optional<Cut> made(const Document& document, const ObjectRanges& objects, Grouping grouping,
                        const Follower& follower)
{
    CutEdit edit(document, grouping);
    TurnProgress turns(follower, double(objects.size()));
    const double tolerance = strokeMillimetres / document.page().millimetresPerUnit();
    for (const std::size_t i : objects) {
        if (turns.stopped())
            break;
        const ObjectView object = document.objects()[i];
        auto stroke = strokeArea(object.path(), object.style(), tolerance, follower.stop);
        turns.turnDone();
        if (stroke.empty()) {
            edit.keep(i);
            continue;
        }
        CutObject result{.left = outlined(object.copy(), std::move(stroke))};
        result.parted = result.left.size() > 1;
        edit.cut(i, std::move(result));
    }
    return edit.take();
}

} // namespace

std::vector<Subpath> strokeArea(const Path& path, const Style& style, double tolerance,
                                const std::stop_token& stop)
{
    if (!style.stroke || !(style.width > 0))
        return {};
    // Of a curve beside a curve, and of its polygon.
    const double each = std::max(tolerance, sizeOf(path) * leastShare) / 4;
    std::vector<Subpath> rings;
    for (const Subpath& subpath : path.subpaths())
        for (const Subpath& part : dashesOf(subpath, style, each)) {
            if (stop.stop_requested())
                return {};
            std::ranges::move(strokeRings(part, style, each), std::back_inserter(rings));
        }
    return united(rings, each, stop);
}

Cut strokesAsAreas(const Document& document, const ObjectRanges& objects, const Follower& follower)
{
    if (auto cut = made(document, objects, Grouping::Yes, follower))
        return std::move(*cut);
    return *made(document, objects, Grouping::No, follower);
}

} // namespace app
