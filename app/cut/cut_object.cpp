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

// What is left of the area, without a stroke along the cut.
std::vector<Object> areasOf(const Object& object, const AreaLeft& area)
{
    if (!area.whole && area.paths.empty())
        return {};
    Object filled = object;
    filled.style.stroke.reset();
    filled.particulars.recipe = {};
    if (!area.whole)
        filled.path = Path(area.paths);
    return {filled};
}

Object outlineOf(Object object)
{
    object.style.stroke = lineColour(object);
    object.style.fill.reset();
    return object;
}

} // namespace

CutObject cutObject(const Object& object, double tolerance, std::span<const Chord> chords,
                    std::span<const Clipped> pieces, std::size_t first, const ClipRegion& region,
                    const std::optional<AreaLeft>& area)
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
    result.whole = result.whole && (!area || area->whole);
    if (result.whole)
        return result;
    if (area)
        result.left = areasOf(object, *area);
    if (!area || object.style.stroke)
        std::ranges::move(objectsOfRuns(outlineOf(object), std::move(runs)),
                          std::back_inserter(result.left));
    return result;
}

} // namespace app
