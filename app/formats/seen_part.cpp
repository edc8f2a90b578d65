// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/seen_part.h"

#include "app/cut/cut.h"
#include "app/cut/cut_object.h"
#include "app/view/cut_fill.h"

#include <algorithm>

namespace app {
namespace {

bool within(const Point& p, const clipping::Window& w)
{
    return p.x >= w.min.x && p.x <= w.max.x && p.y >= w.min.y && p.y <= w.max.y;
}

bool within(const Path& path, const clipping::Window& window)
{
    bool all = true;
    path.forEachPoint([&](const Point& p) { all = all && within(p, window); });
    return all;
}

// The page, enlarged by its own size on every side and by the reach of strokes beyond their lines.
clipping::Window surroundings(const Page& page, const Style& style)
{
    const Point more = page.size + style.width * std::max(1.0, style.miterLimit);
    return {page.min - more, page.min + page.size + more};
}

// The part inside the window of an object's filled area.
Object areaOf(const Object& object, const clipping::Window& window, double tolerance)
{
    std::vector<Subpath> parts;
    std::vector<Chord> chords;
    std::vector<Point> outline;
    for (const Subpath& path : object.path.subpaths()) {
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
        parts.push_back(std::move(part));
    }
    Object area{Path(parts), object.style};
    area.style.stroke.reset();
    return area;
}

// The part inside the window of an object's stroke, bottom to top.
std::vector<Object> strokeIn(Object object, const clipping::Window& window, double tolerance)
{
    object.style.fill.reset();
    CutOptions options{.clipAll = clipping::algorithms().front().corrected.clipAll,
                       .tolerance = tolerance};
    options.region.steps = {{window, WindowOperation::Add}};
    return cutAlone(object, options);
}

void visitReduced(const Object& object, const clipping::Window& window, double tolerance,
                  const std::function<void(const Object&)>& visit)
{
    if (object.style.fill)
        visit(areaOf(object, window, tolerance));
    if (object.style.stroke)
        for (const Object& part : strokeIn(object, window, tolerance))
            visit(part);
}

} // namespace

void visitSeen(const Document& document, const std::function<void(const Object&)>& visit,
               const std::function<void(const Underlay&)>& visitImage)
{
    const std::vector<SeenUnderlay> images = seenUnderlays(document);
    auto nextImage = images.begin();
    const auto visitImagesBelow = [&](std::size_t object) {
        for (; nextImage != images.end() && nextImage->below <= object; ++nextImage)
            visitImage(*nextImage->underlay);
    };
    const double tolerance = usualTolerance(document.page());
    const ObjectRanges hidden = document.containers().hiddenRanges();
    const Objects& objects = document.objects();
    objects.forEach(0, objects.size(), [&](std::size_t i, const ObjectView& view) {
        visitImagesBelow(i);
        if (view.hidden() || hidden.contains(i))
            return;
        Object object{view.path(), view.style()};
        if (!object.path.hasArea())
            object.style.fill.reset();
        const auto window = surroundings(document.page(), object.style);
        if (within(object.path, window))
            visit(object);
        else
            visitReduced(object, window, tolerance, visit);
    });
    visitImagesBelow(objects.size());
}

} // namespace app
