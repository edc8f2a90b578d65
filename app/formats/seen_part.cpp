// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/seen_part.h"

#include "app/document/cut.h"
#include "app/document/flatten.h"
#include "app/view/area.h"

#include <algorithm>

namespace app {
namespace {

bool within(const Point& p, const clipping::Window& w)
{
    return p.x >= w.min.x && p.x <= w.max.x && p.y >= w.min.y && p.y <= w.max.y;
}

bool within(const Subpath& path, const clipping::Window& window)
{
    const auto near = [&](const PathSegment& s) {
        return within(s.to, window)
               && (!s.curved || (within(s.control1, window) && within(s.control2, window)));
    };
    return within(path.start, window) && std::ranges::all_of(path.segments, near);
}

// The page with itself on every side, and what strokes reach beyond their line.
clipping::Window surroundings(const Page& page, const Style& style)
{
    const Point more = page.size + style.width * std::max(1.0, style.miterLimit);
    return {page.min - more, page.min + page.size + more};
}

Shape areaOf(const Shape& shape, const clipping::Window& window, double tolerance)
{
    Shape area{{}, shape.style, {}, shape.layer, false};
    area.style.stroke.reset();
    std::vector<Chord> chords;
    std::vector<Point> outline;
    for (const Subpath& path : shape.paths) {
        chords.clear();
        outline.clear();
        flatten(path, tolerance, chords);
        for (const Chord& chord : chords)
            outline.push_back(chord.segment.a);
        outline.push_back(chords.back().segment.b);
        const auto inside = areaInside(outline, window);
        if (inside.empty())
            continue;
        Subpath part{inside.front(), {}, true};
        for (const Point& point : inside)
            part.segments.push_back({point});
        area.paths.push_back(std::move(part));
    }
    return area;
}

void addReduced(const Shape& shape, const clipping::Window& window, double tolerance, Sheet& seen)
{
    if (shape.style.fill)
        seen.shapes.push_back(areaOf(shape, window, tolerance));
    if (!shape.style.stroke)
        return;
    Sheet stroke{seen.page, seen.layers, {shape}, seen.window};
    stroke.shapes.front().style.fill.reset();
    const CutOptions options{&clipping::algorithms().front().corrected, window, Keep::Inside,
                             tolerance};
    for (Shape& part : cut(stroke, options).sheet.shapes)
        seen.shapes.push_back(std::move(part));
}

} // namespace

Sheet seenPart(const Sheet& sheet)
{
    Sheet seen{sheet.page, sheet.layers, {}, sheet.window};
    const double tolerance = usualTolerance(sheet.page);
    for (Shape shape : sheet.shapes) {
        if (!sheet.shown(shape))
            continue;
        if (!hasArea(shape))
            shape.style.fill.reset();
        const auto window = surroundings(sheet.page, shape.style);
        if (std::ranges::all_of(shape.paths,
                                [&](const Subpath& path) { return within(path, window); }))
            seen.shapes.push_back(std::move(shape));
        else
            addReduced(shape, window, tolerance, seen);
    }
    return seen;
}

} // namespace app
