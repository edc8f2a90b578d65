// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/clip_object.h"

#include "app/cut/cut_ends.h"
#include "app/document/path.h"
#include "app/formats/svg/limits.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace app::svg {
namespace {

using Position = ConvexRegion::Position;

// Curves much larger than the page are flattened only as finely as a picture of 4,000 by 4,000
// pixels needs.
double toleranceFor(const Subpath& path, double tolerance)
{
    Point min = path.start, max = path.start;
    forEachPoint(path, [&](const Point& p) {
        min = glm::min(min, p);
        max = glm::max(max, p);
    });
    return std::max({tolerance, (max.x - min.x) / 4000, (max.y - min.y) / 4000});
}

bool tooManyCurves(const Subpath& path)
{
    return std::size_t(std::ranges::count_if(path.segments, &PathSegment::curved))
           > mostClippedCurves;
}

std::vector<Run> strokeRuns(const Subpath& path, std::span<const Chord> chords,
                            const ConvexRegion& region, ClosedStart closedStart)
{
    std::vector<KeptPart> parts;
    for (std::size_t i = 0; i < chords.size(); ++i)
        if (const auto part = region.clip(chords[i], i))
            parts.push_back(*part);
    const ClipRegion bounds{{{region.bounds(), WindowOperation::Add}}};
    return joinRuns(path, chords, parts, bounds, closedStart);
}

// Whether the polygon has no area, apart from rounding.
bool isFlatPolygon(const std::vector<Point>& polygon)
{
    double area = 0, extent = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        const Point a = polygon[i] - polygon[0], b = polygon[i + 1] - polygon[0];
        area += cross(a, b);
        extent = std::max({extent, std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)});
    }
    return std::abs(area) <= 1e-12 * extent * extent;
}

std::optional<Subpath> filledPart(std::span<const Chord> chords, const ConvexRegion& region)
{
    std::vector<Point> polygon;
    for (const Chord& chord : chords)
        polygon.push_back(chord.segment.a);
    if (!chords.empty())
        polygon.push_back(chords.back().segment.b);
    polygon = region.clip(std::move(polygon));
    while (polygon.size() > 1 && polygon.back() == polygon.front())
        polygon.pop_back();
    if (isFlatPolygon(polygon))
        return std::nullopt;
    Subpath path{polygon.front(), {}, true};
    for (std::size_t i = 1; i < polygon.size(); ++i)
        path.segments.push_back({polygon[i]});
    return path;
}

// How far the corners of a stroke that ends here, at right angles, are from the side of the area on
// which the end lies; 0 if it lies on none.
double gapAt(const Point& end, const Point& before, double width, const ConvexRegion& region)
{
    const auto side = region.sideAt(end);
    return side ? gapAtEdge(side->b - side->a, end - before, width) : 0;
}

bool differs(const std::vector<Run>& runs, double width, const ConvexRegion& region, double visible)
{
    if (width / 2 <= visible)
        return false;
    return std::ranges::any_of(runs, [&](const Run& run) {
        const auto& [start, segments, closed] = run.path;
        if (closed || segments.empty())
            return false;
        const PathSegment &first = segments.front(), &last = segments.back();
        const Point before = segments.size() > 1 ? segments[segments.size() - 2].to : start;
        return gapAt(start, first.curved ? first.control1 : first.to, width, region) > visible
               || gapAt(last.to, last.curved ? last.control2 : before, width, region) > visible;
    });
}

void addStroke(const Drawn& drawn, std::vector<Run> runs, std::vector<Drawn>& objects)
{
    Object outline{{}, drawn.style};
    outline.style.fill.reset();
    for (const Object& object : objectsOfRuns(std::move(outline), std::move(runs)))
        objects.push_back({object.path.subpaths(), object.style, {}, drawn.hidden});
}

} // namespace

std::optional<ClippedObject> clipObject(const Drawn& drawn, const ConvexRegion& region,
                                        double tolerance)
{
    const auto at = [&](const Subpath& path) { return region.position(path); };
    const auto isInside = [](Position p) { return p == Position::Inside; };
    const auto isOutside = [](Position p) { return p == Position::Outside; };
    ClippedObject result;
    result.work = 16; // the cost of testing the object at all
    for (const Subpath& path : drawn.paths)
        result.work += (1 + path.segments.size()) * region.sides();
    if (std::ranges::all_of(drawn.paths, isInside, at)) {
        result.objects.push_back(drawn);
        return result;
    }
    if (std::ranges::all_of(drawn.paths, isOutside, at))
        return result;
    if (std::ranges::any_of(drawn.paths, tooManyCurves))
        return std::nullopt;
    result.cut = true;
    Drawn area{{}, drawn.style, {}, drawn.hidden};
    area.style.stroke.reset();
    std::vector<Run> runs;
    const auto closedStart = drawn.style.dashes.empty() ? ClosedStart::Join : ClosedStart::Break;
    for (const Subpath& path : drawn.paths) {
        if (region.position(path) == Position::Inside) {
            runs.push_back({path, 0});
            area.paths.push_back(path);
            continue;
        }
        std::vector<Chord> chords;
        flatten(path, toleranceFor(path, tolerance), chords);
        result.work += chords.size() * region.sides();
        if (drawn.style.stroke)
            std::ranges::move(strokeRuns(path, chords, region, closedStart),
                              std::back_inserter(runs));
        if (drawn.style.fill)
            if (auto filled = filledPart(chords, region))
                area.paths.push_back(std::move(*filled));
    }
    if (!area.paths.empty() && drawn.style.fill)
        result.objects.push_back(std::move(area));
    constexpr double visibleInTolerances = 10; // half a millimetre
    result.strokeDiffers =
        differs(runs, drawn.style.width, region, visibleInTolerances * tolerance);
    addStroke(drawn, std::move(runs), result.objects);
    if (!result.objects.empty()) {
        result.objects.front().particulars = drawn.particulars;
        result.objects.front().particulars.recipe = {};
    }
    return result;
}

} // namespace app::svg
