// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/clip_meetings.h"

#include "app/cut/box_index.h"
#include "app/document/flatten.h"
#include "app/formats/svg/limits.h"

#include <glm/common.hpp>

namespace app::svg {
namespace {

using Lines = std::vector<clipping::Segment>;

clipping::Window boxAround(const clipping::Segment& line)
{
    return {glm::min(line.a, line.b), glm::max(line.a, line.b)};
}

Lines edgesOf(const ClipRegion& region)
{
    Lines edges;
    for (const ClipRegion::Step& step : region.steps)
        for (const auto& ring : step.rings)
            for (std::size_t i = 0; i < ring.size(); ++i)
                edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
    return edges;
}

// Whether the ends of the second line are not beyond the first one, apart from rounding.
bool dividesEnds(const clipping::Segment& line, const clipping::Segment& other)
{
    const Point along = line.b - line.a;
    return cross(along, other.a - line.a) * cross(along, other.b - line.a) <= 0;
}

// Whether lines of both meet too often. Few cannot.
bool meetTooOften(const Lines& some, const Lines& others)
{
    if (some.size() * others.size() <= mostClipMeetings)
        return false;
    std::vector<clipping::Window> boxes;
    for (const clipping::Segment& line : others)
        boxes.push_back(boxAround(line));
    const BoxIndex index(boxes);
    std::size_t near = 0, meetings = 0;
    for (const clipping::Segment& line : some) {
        index.meeting(boxAround(line), 0, [&](std::uint32_t i) {
            ++near;
            meetings += dividesEnds(line, others[i]) && dividesEnds(others[i], line);
        });
        if (meetings > mostClipMeetings || near > mostNearClips)
            return true;
    }
    return false;
}

} // namespace

ClipMeetings::ClipMeetings(const Objects& objects, const ClipRegion& region, double tolerance)
{
    const Lines edges = edgesOf(region);
    edges_ = edges.size();
    tooMany_ = meetTooOften(edges, edges);
    Lines lines;
    std::vector<Chord> chords;
    objects.forEach(0, objects.size(), [&](std::size_t, const ObjectView& object) {
        chords.clear();
        flatten(object.path(), tolerance, chords);
        const std::size_t first = lines.size();
        for (const Chord& chord : chords)
            lines.push_back(chord.segment);
        if (object.style().fill && !tooMany_) {
            const Lines own(lines.begin() + std::ptrdiff_t(first), lines.end());
            tooMany_ = meetTooOften(own, own);
        }
    });
    chords_ = lines.size();
    tooMany_ = tooMany_ || meetTooOften(lines, edges);
}

} // namespace app::svg
