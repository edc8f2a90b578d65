// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/cut_object.h"

#include "app/cut/area_outline.h"
#include "app/cut/cut_ends.h"
#include "app/document/object_view.h"
#include "app/scene/area_windows.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace app {
AreaCut::AreaCut(const ClipRegion& region, const std::stop_token& stop)
    : windows_(areaWindows(region)), stop_(stop)
{
}

AreaLeft AreaCut::left(const Path& path, FillRule rule, std::span<const Chord> chords,
                       const CurvedBorder& border) const
{
    const std::vector<Subpath> subpaths = path.subpaths();
    const FlatArea flat = flatAreaOf(subpaths, rule, chords);
    const clipping::ClippedArea clipped = clipping::clipArea(flat.area, *windows_, stop_);
    if (clipped.part == clipping::AreaPart::Whole)
        return {.whole = true};
    if (clipped.part != clipping::AreaPart::Cut)
        return {};
    return {.paths = subpathsOf(clipped, subpaths, flat, *windows_, border)};
}

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

/// How many chords belong to the first subpath.
std::size_t chordsOfFirst(std::span<const Chord> chords)
{
    const auto begins = [](const Chord& chord) { return chord.pathSegment == 0 && chord.t0 == 0; };
    const auto next = std::find_if(chords.begin() + 1, chords.end(), begins);
    return std::size_t(next - chords.begin());
}

double lengthOf(const Subpath& path, double tolerance)
{
    std::vector<Chord> chords;
    flatten(path, tolerance, chords);
    double length = 0;
    for (const Chord& chord : chords)
        length += std::hypot(chord.segment.b.x - chord.segment.a.x,
                             chord.segment.b.y - chord.segment.a.y);
    return length;
}

bool isTooShort(const Subpath& path, const CutOptions& options)
{
    return options.leastLength > 0 && lengthOf(path, options.tolerance) < options.leastLength;
}

bool enclosesNothing(const Subpath& path)
{
    return path.segments.empty() || (path.segments.size() == 1 && !path.segments[0].curved);
}

// The kept part of a filled object as an object; empty if nothing of it is kept.
std::vector<Object> areasOf(const Object& object, const std::vector<Subpath>& paths)
{
    if (paths.empty())
        return {};
    Object filled = object;
    filled.particulars.recipe = {};
    filled.path = Path(paths);
    return {filled};
}

Object withoutStroke(Object object)
{
    object.style.stroke.reset();
    return object;
}

Object outlineOf(Object object)
{
    object.style.stroke = lineColour(object);
    object.style.fill.reset();
    return object;
}

// The lines of an object, cut.
class CutLines {
public:
    CutLines(const Object& object, const CutOptions& options, const CurvedBorder& border)
        : object_(object), options_(options), border_(border),
          closedStart_(object.style.dashes.empty() ? ClosedStart::Join : ClosedStart::Break)
    {
    }

    void cut(std::span<const Chord> chords, std::span<const Clipped> pieces, std::size_t first)
    {
        for (const Subpath& path : object_.path.subpaths()) {
            const std::size_t count = chordsOfFirst(chords);
            add(path, chords.first(count), partsOf(count, pieces, first));
            chords = chords.subspan(count);
            first += count;
        }
    }

    bool whole() const { return whole_; }
    std::size_t opened() const { return opened_; }
    std::size_t dropped() const { return dropped_; }
    bool slanted() const { return slanted_; }
    /// The lines of all subpaths, or of those that enclose nothing.
    std::vector<Object> take() { return objectsOfRuns(outlineOf(object_), std::move(runs_)); }
    std::vector<Object> takeLoose() { return objectsOfRuns(outlineOf(object_), std::move(loose_)); }

private:
    void add(const Subpath& path, std::span<const Chord> chords, const std::vector<KeptPart>& parts)
    {
        auto kept = joinRuns(path, chords, parts, options_.region, closedStart_, border_);
        const bool unchanged = kept.size() == 1 && kept.front().path == path;
        if (!unchanged) {
            std::erase_if(kept, [&](const Run& run) { return border_.isNothing(run.path); });
            dropped_ +=
                std::erase_if(kept, [&](const Run& run) { return isTooShort(run.path, options_); });
        }
        whole_ = whole_ && unchanged;
        slanted_ = slanted_ || endsSlanted(chords, parts);
        opened_ += path.closed && !unchanged && !kept.empty();
        if (enclosesNothing(path))
            loose_.insert(loose_.end(), kept.begin(), kept.end());
        std::ranges::move(kept, std::back_inserter(runs_));
    }

    bool endsSlanted(std::span<const Chord> chords, const std::vector<KeptPart>& parts) const
    {
        const double width = object_.style.width, wide = options_.wideStroke;
        constexpr double seen = 0.1; // of a wide stroke
        return object_.style.stroke && wide > 0 && width > wide
               && std::ranges::any_of(parts, [&](const KeptPart& part) {
                      return gapAtEnds(chords[part.chord].segment, part, width, options_.region)
                             > seen * wide;
                  });
    }

    const Object& object_;
    const CutOptions& options_;
    const CurvedBorder& border_;
    const ClosedStart closedStart_;
    std::vector<Run> runs_, loose_;
    bool whole_ = true, slanted_ = false;
    std::size_t opened_ = 0, dropped_ = 0;
};

} // namespace

CutObject cutObject(const Object& object, const CutOptions& options, std::span<const Chord> chords,
                    std::span<const Clipped> pieces, std::size_t first,
                    const std::optional<AreaLeft>& area, const CurvedBorder& border)
{
    CutLines lines(object, options, border);
    lines.cut(chords, pieces, first);
    if (lines.whole() && (!area || area->whole))
        return {.whole = true};
    const bool stroked = object.style.stroke.has_value();
    const bool hasLines = stroked || !area; // otherwise only the area counts
    CutObject result{.opened = hasLines ? lines.opened() : 0,
                     .dropped = hasLines ? lines.dropped() : 0,
                     .slanted = lines.slanted()};
    if (!area) {
        result.left = lines.take();
        return result;
    }
    std::vector<Subpath> rings = area->whole ? object.path.subpaths() : area->paths;
    if (options.closeAreas && stroked) {
        result.opened = 0;
        result.slanted = false;
        result.dropped =
            std::erase_if(rings, [&](const Subpath& ring) { return isTooShort(ring, options); });
        result.left = areasOf(object, rings);
    } else {
        result.left = areasOf(withoutStroke(object), rings);
    }
    const std::size_t areas = result.left.size();
    if (stroked)
        std::ranges::move(options.closeAreas ? lines.takeLoose() : lines.take(),
                          std::back_inserter(result.left));
    result.parted = areas > 0 && result.left.size() > areas;
    return result;
}

} // namespace app
