// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/picture.h"

#include "app/view/difference_marks.h"
#include "app/view/ink.h"
#include "app/view/plating.h"

#include <algorithm>

namespace app {
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

// Areas stay as faint as ever, or they would drown what is kept.
void makeGhosts(Plate& plate, const Ghosting& ghosting)
{
    for (Coat& coat : plate.coats)
        if (coat.stroke)
            coat.stroke->colour = ghostInk(coat.stroke->colour, ghosting.page, ghosting.opacity);
        else
            coat.fill.alpha = std::uint8_t(coat.fill.alpha * ghosting.opacity);
}

} // namespace

Picture picture(const Sheet& sheet, const Scene& scene, const Frame& frame,
                const PictureOptions& options)
{
    const bool inside = options.keep == Keep::Inside;
    Picture picture;
    picture.lit = lit(sheet, scene, options);
    picture.differing = differenceMarks(sheet, scene, options);
    if (options.removed == RemovedPart::Shown) {
        picture.kept = plate(sheet, scene, untouched(scene.segments()), options);
        return picture;
    }
    if (options.removed == RemovedPart::Ghosted)
        picture.ghost = plate(sheet, scene, inside ? frame.outside : frame.inside, options);
    if (options.ghosting)
        makeGhosts(picture.ghost, *options.ghosting);
    picture.kept = plate(sheet, scene, inside ? frame.inside : frame.outside, options);
    return picture;
}

} // namespace app
