// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/picture.h"

#include "app/view/plating.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace app {

using clipping::Segment;

namespace {

// All pieces of one shape are consecutive; shapes come in their order.
Plate plate(const Sheet& sheet, const Scene& scene, std::span<const clipping::Clipped> pieces,
            const PictureOptions& options)
{
    Plating plating(options, pieces.size());
    std::size_t shape = 0;
    for (std::size_t i = 0; i < pieces.size();) {
        while (scene.firstSegmentOf(shape + 1) <= pieces[i].source)
            ++shape;
        const std::size_t first = scene.firstSegmentOf(shape),
                          end = scene.firstSegmentOf(shape + 1);
        std::size_t next = i + 1;
        while (next < pieces.size() && pieces[next].source < end)
            ++next;
        plating.add(sheet.shapes[shape], scene.segments().subspan(first, end - first), first,
                    pieces.subspan(i, next - i));
        i = next;
    }
    return plating.take();
}

std::vector<clipping::Clipped> untouched(std::span<const clipping::Segment> segments)
{
    std::vector<clipping::Clipped> all;
    all.reserve(segments.size());
    for (const auto& segment : segments)
        all.push_back({segment, std::uint32_t(all.size()), 0});
    return all;
}

constexpr double leastLit = 1.5; // pixels

// Whole, whatever of them the window leaves.
Plate lit(const Sheet& sheet, const Scene& scene, const PictureOptions& options)
{
    Plating plating(options, options.selection.size());
    for (const std::size_t index : options.selection) {
        Shape shape = sheet.shapes[index];
        const auto first = scene.firstSegmentOf(index), end = scene.firstSegmentOf(index + 1);
        const auto whole = scene.segments().subspan(first, end - first);
        if (whole.empty())
            continue;
        shape.style.fill.reset();
        shape.style.stroke = options.light;
        shape.style.width = std::max(shape.style.width, leastLit / options.view.zoom);
        const auto pieces = untouched(whole);
        plating.add(shape, whole, 0, pieces);
    }
    return plating.take();
}

// What differs is thicker than what it lies upon.
constexpr double leastDiffering = 2.25, thicker = 1.5; // pixels
constexpr double tickLength = 8, tooShort = 6;         // pixels
constexpr std::size_t mostShortTicks = 300;            // seen; more are no help

// With ticks of more pieces than can be told apart nothing else would be seen.
std::optional<Segment> tickOf(const Segment& piece, const PictureOptions& options, bool few)
{
    const Point along = piece.b - piece.a;
    const double length = glm::length(along), pixels = length * options.view.zoom;
    const bool isShort = pixels < tooShort;
    if (isShort ? !few : options.ticks == PictureOptions::Ticks::WhereShort)
        return std::nullopt;
    const double tick = isShort ? tickLength : std::min(tickLength, 0.75 * pixels);
    const Point across = length > 0 ? Point(-along.y, along.x) / length : Point(0.6, 0.8);
    const Point half = across * (tick / 2 / options.view.zoom);
    const Point middle = piece.a + along / 2.0;
    return Segment{middle - half, middle + half};
}

bool isSeen(const clipping::Clipped& piece, const clipping::Window& view)
{
    const auto& [a, b] = piece.segment;
    return std::max(a.x, b.x) >= view.min.x && std::min(a.x, b.x) <= view.max.x
           && std::max(a.y, b.y) >= view.min.y && std::min(a.y, b.y) <= view.max.y;
}

Plate differing(const Sheet& sheet, const Scene& scene, const PictureOptions& options)
{
    Plating plating(options, 2 * options.differing.size());
    Shape mark;
    mark.style.stroke = options.marked;
    const clipping::Window view = options.view.visible();
    std::vector<Segment> seen, ticks;
    const auto paint = [&](std::vector<Segment>& segments, double pixels) {
        mark.style.width = pixels / options.view.zoom;
        if (!segments.empty())
            plating.add(mark, segments, 0, untouched(segments));
        segments.clear();
    };
    double width = 0;
    for (const clipping::Clipped& piece : options.differing) {
        if (piece.source >= scene.segments().size() || !isSeen(piece, view))
            continue;
        const Style& style = sheet.shapes[scene.shapeOf(piece.source)].style;
        const double own = style.stroke ? style.width * options.view.zoom : 0;
        const double wanted = std::max(leastDiffering, own + thicker);
        if (wanted != width)
            paint(seen, width);
        width = wanted;
        seen.push_back(piece.segment);
        ticks.push_back(piece.segment);
    }
    paint(seen, width);
    const bool few = ticks.size() <= mostShortTicks;
    for (const Segment& piece : std::exchange(ticks, {}))
        if (const auto tick = tickOf(piece, options, few))
            ticks.push_back(*tick);
    paint(ticks, leastDiffering);
    return plating.take();
}

} // namespace

Picture picture(const Sheet& sheet, const Scene& scene, const Frame& frame,
                const PictureOptions& options)
{
    const bool inside = options.keep == Keep::Inside;
    Picture picture;
    picture.lit = lit(sheet, scene, options);
    picture.differing = differing(sheet, scene, options);
    if (options.removed == RemovedPart::Shown) {
        picture.kept = plate(sheet, scene, untouched(scene.segments()), options);
        return picture;
    }
    if (options.removed == RemovedPart::Ghosted)
        picture.ghost = plate(sheet, scene, inside ? frame.outside : frame.inside, options);
    picture.kept = plate(sheet, scene, inside ? frame.inside : frame.outside, options);
    return picture;
}

} // namespace app
