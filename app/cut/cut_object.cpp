// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/cut_object.h"

#include "app/cut/runs.h"
#include "app/document/line_colour.h"

#include <algorithm>
#include <iterator>

namespace app {
namespace {

using clipping::Clipped;

// Takes the pieces of the first `chords` chords from `pieces`. The chord numbers of the parts count
// from `first`.
std::vector<KeptPart> partsOf(std::size_t chords, std::span<const Clipped>& pieces,
                              std::size_t first)
{
    std::vector<KeptPart> parts;
    while (!pieces.empty() && pieces.front().source - first < chords) {
        const Clipped& piece = pieces.front();
        parts.push_back({piece.source - first, piece.segment, clipping::cutEdgeOfA(piece.cut),
                         clipping::cutEdgeOfB(piece.cut)});
        pieces = pieces.subspan(1);
    }
    return parts;
}

} // namespace

CutObject cutObject(const Object& object, double tolerance, std::span<const Chord> chords,
                    std::span<const Clipped> pieces, std::size_t first, const ClipRegion& region)
{
    const ClosedStart closedStart =
        object.style.dashes.empty() ? ClosedStart::Join : ClosedStart::Break;
    CutObject result{.whole = true};
    std::vector<Run> runs;
    for (const Subpath& path : object.path.subpaths()) {
        const std::size_t count = chordCount(path, tolerance);
        const auto parts = partsOf(count, pieces, first);
        auto kept = joinRuns(path, chords.first(count), parts, region, closedStart);
        const bool unchanged = kept.size() == 1 && kept.front().path == path;
        result.whole = result.whole && unchanged;
        result.opened += path.closed && !unchanged && !kept.empty();
        std::ranges::move(kept, std::back_inserter(runs));
        chords = chords.subspan(count);
        first += count;
    }
    if (result.whole)
        return result;
    Object outline = object;
    outline.style.stroke = lineColour(object);
    outline.style.fill.reset();
    result.left = objectsOfRuns(std::move(outline), std::move(runs));
    return result;
}

} // namespace app
