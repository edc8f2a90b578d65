// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/clip_meetings.h"

#include "app/cut/box_index.h"
#include "app/document/flatten.h"
#include "app/formats/svg/limits.h"

#include <glm/common.hpp>

namespace app::svg {
namespace {

using LineBoxes = std::vector<clipping::Window>;

clipping::Window boxAround(const Point& a, const Point& b)
{
    return {glm::min(a, b), glm::max(a, b)};
}

LineBoxes edgesOf(const ClipRegion& region)
{
    LineBoxes boxes;
    for (const ClipRegion::Step& step : region.steps)
        for (const auto& ring : step.rings)
            for (std::size_t i = 0; i < ring.size(); ++i)
                boxes.push_back(boxAround(ring[i], ring[(i + 1) % ring.size()]));
    return boxes;
}

// Whether boxes of both meet too often. Few cannot.
bool meetTooOften(const LineBoxes& some, const LineBoxes& others)
{
    if (some.size() * others.size() <= mostClipMeetings)
        return false;
    const BoxIndex index(others);
    std::size_t meetings = 0;
    for (const clipping::Window& box : some) {
        index.meeting(box, 0, [&](std::uint32_t) { ++meetings; });
        if (meetings > mostClipMeetings)
            return true;
    }
    return false;
}

} // namespace

ClipMeetings::ClipMeetings(const Objects& objects, const ClipRegion& region, double tolerance)
{
    const LineBoxes edges = edgesOf(region);
    edges_ = edges.size();
    tooMany_ = meetTooOften(edges, edges);
    LineBoxes lines;
    std::vector<Chord> chords;
    objects.forEach(0, objects.size(), [&](std::size_t, const ObjectView& object) {
        chords.clear();
        flatten(object.path(), tolerance, chords);
        const std::size_t first = lines.size();
        for (const Chord& chord : chords)
            lines.push_back(boxAround(chord.segment.a, chord.segment.b));
        if (object.style().fill && !tooMany_) {
            const LineBoxes own(lines.begin() + std::ptrdiff_t(first), lines.end());
            tooMany_ = meetTooOften(own, own);
        }
    });
    chords_ = lines.size();
    tooMany_ = tooMany_ || meetTooOften(lines, edges);
}

} // namespace app::svg
