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

constexpr double leastDiffering = 2.25;          // pixels; look.md asks for 1.9
constexpr double tickLength = 8, longEnough = 6; // pixels

std::optional<Segment> tickOf(const Segment& piece, const PictureOptions& options)
{
    const Point along = piece.b - piece.a;
    const double length = glm::length(along), zoom = options.view.zoom;
    if (options.ticks == PictureOptions::Ticks::WhereShort && length * zoom >= longEnough)
        return std::nullopt;
    const Point across = length > 0 ? Point(-along.y, along.x) / length : Point(0.6, 0.8);
    const Point middle = piece.a + along / 2.0, half = across * (tickLength / 2 / zoom);
    return Segment{middle - half, middle + half};
}

// A tick says where a piece is that is too short to be seen, and that it is marked.
Plate differing(const PictureOptions& options)
{
    Plating plating(options, 2 * options.differing.size());
    if (options.differing.empty())
        return plating.take();
    Shape shape;
    shape.style.stroke = options.marked;
    shape.style.width = leastDiffering / options.view.zoom;
    plating.add(shape, options.differing, 0, untouched(options.differing));
    std::vector<Segment> ticks;
    for (const Segment& piece : options.differing)
        if (const auto tick = tickOf(piece, options))
            ticks.push_back(*tick);
    if (!ticks.empty())
        plating.add(shape, ticks, 0, untouched(ticks));
    return plating.take();
}

} // namespace

Picture picture(const Sheet& sheet, const Scene& scene, const Frame& frame,
                const PictureOptions& options)
{
    const bool inside = options.keep == Keep::Inside;
    Picture picture;
    picture.lit = lit(sheet, scene, options);
    picture.differing = differing(options);
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
