// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/snapping/snapper.h"

#include "app/document/window_outline.h"
#include "app/view/snapping/places.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr std::size_t leastLines = 32, mostLooks = 50'000, mostAligned = 1500, mostPoints = 20'000,
                      mostCurves = 200;

bool isNear(const SnapSurroundings& near, const Point& min, const Point& max)
{
    const Point least = near.pointer - near.radius, most = near.pointer + near.radius;
    return min.x <= most.x && min.y <= most.y && max.x >= least.x && max.y >= least.y;
}

void addSnapLine(const clipping::Segment& line, SnapSurroundings& near)
{
    if (isNear(near, glm::min(line.a, line.b), glm::max(line.a, line.b)))
        near.lines.push_back(line);
}

void addCurve(const Bezier& c, SnapSurroundings& near)
{
    const Point min = glm::min(glm::min(c.from, c.to), glm::min(c.control1, c.control2));
    const Point max = glm::max(glm::max(c.from, c.to), glm::max(c.control1, c.control2));
    if (near.curves.size() < mostCurves && isNear(near, min, max))
        near.curves.push_back(c);
}

/// Adds the lines and curves that are near.
void addSubpath(const Subpath& subpath, SnapSurroundings& near)
{
    Point from = subpath.start;
    for (const PathSegment& segment : subpath.segments) {
        if (segment.curved)
            addCurve({from, segment.control1, segment.control2, segment.to}, near);
        else
            addSnapLine({from, segment.to}, near);
        from = segment.to;
    }
    if (subpath.closed && from != subpath.start)
        addSnapLine({from, subpath.start}, near);
}

clipping::Window boxOf(const Subpath& part)
{
    const Point &a = part.start, &b = part.segments.back().to;
    return {glm::min(a, b), glm::max(a, b)};
}

clipping::Window boundsOf(const SceneLines& lines, std::size_t first, std::size_t count)
{
    clipping::Window box{lines[first].a, lines[first].a};
    lines.forEachPart(first, first + count, [&](std::size_t run, std::size_t from, std::size_t to) {
        for (const auto& line : lines.runs()[run].segments.subspan(from, to - from))
            box = {glm::min(box.min, glm::min(line.a, line.b)),
                   glm::max(box.max, glm::max(line.a, line.b))};
    });
    return box;
}

} // namespace

// Nothing snaps to a curved window: the corners of its inscribed polygon mean nothing to a person.
static std::vector<std::vector<Point>> straightRings(const WindowShape& shape)
{
    if (const auto* curved = std::get_if<PathShape>(&shape); curved && !curved->path.straight())
        return {};
    return outlineOf(shape, 1).rings;
}

static std::vector<clipping::Segment> edgesNear(const SnapSurroundings& near,
                                                const WindowShape& shape)
{
    std::vector<clipping::Segment> edges;
    for (const auto& ring : straightRings(shape))
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
            if (isNear(near, glm::min(a, b), glm::max(a, b)))
                edges.push_back({a, b});
        }
    return edges;
}

// An ellipse offers its centre and the ends of its radii.
static void addEllipse(const EllipseRecipe& ellipse, const SnapQuery& query, SnapSurroundings& near)
{
    if (query.to.has("centres"))
        near.centres.push_back(ellipse.centre);
    const Point x = turnedBy({ellipse.radii.x, 0}, ellipse.turn),
                y = turnedBy({0, ellipse.radii.y}, ellipse.turn);
    for (const Point& away : {x, y, -x, -y})
        if (const Point p = ellipse.centre + away; isNear(near, p, p))
            near.windowEdges.push_back({p, p});
}

static void addWindow(const WindowShape& shape, const SnapQuery& query, SnapSurroundings& near)
{
    if (const EllipseRecipe* ellipse = ellipseOf(shape))
        addEllipse(*ellipse, query, near);
    std::ranges::copy(edgesNear(near, shape), std::back_inserter(near.windowEdges));
}

// The clip windows that are snapped to.
static std::vector<const WindowShape*> windowsFor(const SnapQuery& query, const Document& document)
{
    std::vector<const WindowShape*> shapes;
    const auto& list = document.windows().list;
    for (std::size_t i = 0; query.to.has("window") && i < list.size(); ++i)
        if (list[i].visible && i != query.withoutWindow)
            shapes.push_back(&list[i].shape);
    return shapes;
}

std::optional<Snap> snapToEdges(const Point& pointer, double radius, const clipping::Window& window)
{
    SnapSurroundings near{pointer, radius};
    near.windowEdges = edgesNear(near, RectangleShape{window});
    SnapOffers offers(pointer, radius);
    offers.begin(snapKind("window"));
    snapKind("window").find(near, offers);
    return offers.best();
}

SnapOffers Snapper::offers(const SnapQuery& query) const
{
    const SnapSurroundings near = around(query);
    SnapOffers offers(query.pointer, query.radius);
    for (const SnapKind& kind : snapKinds())
        if (query.to.has(kind) && kind.find) {
            offers.begin(kind);
            kind.find(near, offers);
        }
    return offers;
}

std::optional<Snap> Snapper::at(const SnapQuery& query) const
{
    const SnapOffers found = offers(query);
    if (found.best() && found.rank() != SnapRank::Grid)
        return found.best();
    if (!query.to.has("drawn-alignment") || !query.seen)
        return found.best();
    const Alignment alignment = aligned({query.pointer, query.pointer}, query);
    if (alignment.lines.empty())
        return found.best();
    return Snap{query.pointer + alignment.by, &snapKind("drawn-alignment"), false, alignment.lines};
}

MovedSnap Snapper::moved(const OwnPoints& own, const Point& by, SnapQuery query) const
{
    const std::size_t count = std::max(own.points.size(), std::size_t(1));
    query.limits = {std::max(leastLines, query.limits.found / count), mostLooks / count};
    std::optional<SnapOffers> best;
    Point to = by;
    for (const Point& point : own.points) {
        query.pointer = point + by;
        const SnapOffers found = offers(query);
        const bool better =
            !best || found.rank() < best->rank()
            || (found.rank() == best->rank() && found.distance() < best->distance());
        if (!found.best() || !better)
            continue;
        best = found;
        to = found.best()->point - point;
    }
    if (best && best->rank() != SnapRank::Grid)
        return {to, best->best()};
    const bool aligns = query.to.has("alignment") && query.seen;
    const clipping::Window bounds{own.bounds.min + by, own.bounds.max + by};
    const Alignment alignment = aligns ? aligned(bounds, query) : Alignment{};
    if (alignment.lines.empty())
        return {to, best ? best->best() : std::nullopt};
    Point aligned = by + alignment.by;
    const bool square = query.grid && query.grid->u.y == 0 && query.grid->v.x == 0;
    if (best && square && alignment.lines.size() == 1) { // the grid decides the other axis
        const int other = 1 - alignment.lines.front().axis;
        aligned[other] = to[other];
    }
    return {aligned, std::nullopt, alignment.lines};
}

Alignment Snapper::aligned(const clipping::Window& box, const SnapQuery& query) const
{
    return align(box, boxesAround((box.min + box.max) * 0.5, query), query.radius);
}

// The boxes to align with. In a crowd only those of the nearest lines.
std::vector<clipping::Window> Snapper::boxesAround(const Point& centre,
                                                   const SnapQuery& query) const
{
    const SceneLines& lines = scene_.lines();
    const auto& [min, max] = *query.seen;
    std::vector<clipping::Window> boxes;
    std::size_t known = 0, looked = 0; // the first object that is not known; lines
    const double reach = glm::distance(centre, (min + max) * 0.5) + glm::distance(min, max) / 2;
    for (const std::size_t line : picking_.near(centre, reach, {mostAligned, mostLooks})) {
        if (line < lines.firstLineOf(known))
            continue;
        const std::size_t object = lines.objectOf(line);
        known = object + 1;
        const std::size_t first = lines.firstLineOf(object),
                          count = lines.firstLineOf(known) - first;
        if (query.without.contains(object) || looked + count > mostPoints)
            continue;
        looked += count;
        const clipping::Window box = boundsOf(lines, first, count);
        if (box.max.x >= min.x && box.max.y >= min.y && box.min.x <= max.x && box.min.y <= max.y)
            boxes.push_back(box);
    }
    if (query.parts)
        for (std::size_t i = 0; i < std::min(query.parts->size(), mostAligned); ++i)
            boxes.push_back(boxOf((*query.parts)[i]));
    if (query.from)
        boxes.push_back({*query.from, *query.from});
    if (query.to.has("page"))
        boxes.push_back(document_.now().page().rectangle());
    for (const WindowShape* shape : windowsFor(query, document_.now()))
        if (const auto box = axisAlignedBox(*shape))
            boxes.push_back(*box);
    return boxes;
}

SnapSurroundings Snapper::around(const SnapQuery& query) const
{
    SnapSurroundings near{query.pointer, query.radius, query.from};
    near.grid = query.grid;
    if (query.guides)
        std::ranges::copy_if(
            query.guides->list, std::back_inserter(near.guides), [&](const Guide& guide) {
                return std::abs(guide.at - query.pointer[guide.axis]) <= query.radius;
            });
    addLines(query, near);
    if (query.to.has("centres"))
        near.centres = centres_.near(query.pointer, query.radius, query.without);
    for (const WindowShape* shape : windowsFor(query, document_.now()))
        addWindow(*shape, query, near);
    if (query.to.has("page"))
        near.pageEdges = edgesNear(near, RectangleShape{document_.now().page().rectangle()});
    return near;
}

void Snapper::addLines(const SnapQuery& query, SnapSurroundings& near) const
{
    const SceneLines& lines = scene_.lines();
    const Objects& objects = document_.now().objects();
    std::size_t points = 0; // of curved objects
    std::optional<std::size_t> last;
    bool straight = false;
    for (const std::size_t line : picking_.near(query.pointer, query.radius, query.limits)) {
        const std::size_t object = lines.objectOf(line);
        if (query.without.contains(object))
            continue;
        near.chords.push_back(lines[line]);
        if (object != last) {
            last = object;
            const Path path = objects[object].path();
            straight = path.straight();
            if (!straight && points + path.pointCount() <= mostPoints) {
                points += path.pointCount();
                for (const Subpath& subpath : path.subpaths())
                    addSubpath(subpath, near);
            }
        }
        if (straight)
            near.lines.push_back(lines[line]);
    }
    addParts(query, near);
}

void Snapper::addParts(const SnapQuery& query, SnapSurroundings& near)
{
    if (!query.parts)
        return;
    const std::size_t before = near.lines.size();
    for (const Subpath& part : *query.parts)
        addSubpath(part, near);
    std::copy_if(near.lines.begin() + std::ptrdiff_t(before), near.lines.end(),
                 std::back_inserter(near.chords),
                 [](const clipping::Segment& line) { return line.a != line.b; });
}

} // namespace app
