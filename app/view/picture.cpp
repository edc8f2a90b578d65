// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/picture.h"

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

std::vector<clipping::Clipped> untouched(std::span<const clipping::Segment> segments)
{
    std::vector<clipping::Clipped> all;
    all.reserve(segments.size());
    for (const auto& segment : segments)
        all.push_back({segment, std::uint32_t(all.size()), 0});
    return all;
}

} // namespace

Picture picture(const Sheet& sheet, const Scene& scene, const Frame& frame,
                const PictureOptions& options)
{
    if (options.removed == RemovedPart::Shown)
        return {{}, plate(sheet, scene, untouched(scene.segments()), options)};
    const bool inside = options.keep == Keep::Inside;
    Picture picture;
    if (options.removed == RemovedPart::Ghosted)
        picture.ghost = plate(sheet, scene, inside ? frame.outside : frame.inside, options);
    picture.kept = plate(sheet, scene, inside ? frame.inside : frame.outside, options);
    return picture;
}

} // namespace app
