// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/cut.h"

#include "app/base/progress.h"
#include "app/cut/curved_border.h"
#include "app/cut/cut_each.h"
#include "app/cut/cut_edit.h"
#include "app/cut/cut_images.h"
#include "app/cut/line_clipping.h"

#include <algorithm>
#include <cassert>

namespace app {
namespace {

using clipping::Clipped;

constexpr std::size_t chordsAtOnce = 65'536; // of whole objects; a single object may have more

// The chords of many objects in one array, so that one call of the algorithm clips them all.
class Batch {
public:
    struct Member {
        std::size_t object;
        std::size_t first, end; ///< its chords in the array
    };

    void add(std::size_t number, const ObjectView& object, double tolerance,
             const CurvedBorder& border)
    {
        const std::size_t first = chords_.size();
        border.flattenAlong(object.path(), tolerance, chords_);
        members_.push_back({number, first, chords_.size()});
    }

    std::span<const Member> members() const { return members_; }
    std::span<const Chord> chords() const { return chords_; }
    std::span<const Chord> chordsOf(const Member& member) const
    {
        return chords().subspan(member.first, member.end - member.first);
    }
    void clear()
    {
        chords_.clear();
        members_.clear();
    }

private:
    std::vector<Chord> chords_;
    std::vector<Member> members_;
};

// The parts of chords that are kept.
class ChordClipping {
public:
    explicit ChordClipping(const CutOptions& options, const std::stop_token& stop = {})
        : clipping_(options, stop)
    {
    }

    std::span<const std::uint32_t> contacts() const { return clipping_.contacts(); }
    std::span<const Clipped> keptOf(std::span<const Chord> chords)
    {
        lines_.resize(chords.size());
        std::ranges::transform(chords, lines_.begin(), &Chord::segment);
        return clipping_.keptOf(lines_);
    }

private:
    LineClipping clipping_;
    std::vector<clipping::Segment> lines_;
};

bool isOnlyPoints(const Object& object)
{
    return std::ranges::all_of(object.path.subpaths(), [](const Subpath& path) {
        return std::ranges::all_of(path.segments, [&](const PathSegment& segment) {
            return !segment.curved && segment.to == path.start;
        });
    });
}

CutOptions withTolerance(CutOptions options, const Page& page)
{
    if (!(options.tolerance > 0))
        options.tolerance = usualTolerance(page);
    return options;
}

/// With the border's windows as polygons, divided where the drawing's lines and curves end on it.
CutOptions dividedAt(CurvedBorder& border, const Objects& objects, const Page& page,
                     CutOptions options, const std::stop_token& stop)
{
    border.divideFor(objects, options.tolerance, stop);
    return atPolygons(std::move(options), border, page);
}

/// Cuts objects, and tells an edit (CutEdit, or one with its functions) what becomes of each.
template <class SomeEdit>
class Cutter {
public:
    Cutter(const Objects& objects, const Page& page, const CutOptions& options, SomeEdit& edit,
           const Follower& follower)
        : objects_(objects),
          border_(options.windows, page, options.coincident, CurvedBorder::sidesFor(objects)),
          options_(dividedAt(border_, objects, page, withTolerance(options, page), follower.stop)),
          edit_(edit), clipping_(options_, follower.stop), areas_(options_.region, follower.stop),
          turns_(follower, double(objects_.size()))
    {
    }

    void cut()
    {
        objects_.forEach(0, objects_.size(), [&](std::size_t i, const ObjectView& object) {
            if (turns_.stopped() || !reached(i))
                return;
            batch_.add(i, object, options_.tolerance, border_);
            if (batch_.chords().size() >= chordsAtOnce)
                cutBatch();
        });
        cutBatch();
    }

private:
    bool reached(std::size_t i)
    {
        const bool locked = options_.leaveLocked && edit_.isLocked(i);
        const bool hidden = !locked && options_.leaveHidden && edit_.isHidden(i);
        edit_.counts().leftLocked += locked;
        edit_.counts().leftHidden += hidden;
        return !locked && !hidden;
    }

    void cutBatch()
    {
        std::span<const Clipped> kept = clipping_.keptOf(batch_.chords());
        edit_.counts().segmentsBefore += batch_.chords().size();
        edit_.counts().segmentsAfter += kept.size();
        std::span<const std::uint32_t> contacts = clipping_.contacts();
        for (const Batch::Member& member : batch_.members()) {
            if (turns_.stopped())
                return;
            const auto end = std::ranges::find_if(
                kept, [&](const Clipped& piece) { return piece.source >= member.end; });
            const auto count = std::size_t(end - kept.begin());
            const auto touching = std::ranges::lower_bound(contacts, member.end);
            const bool touches = touching != contacts.begin();
            contacts = contacts.subspan(std::size_t(touching - contacts.begin()));
            cutMember(member, kept.first(count), touches);
            kept = kept.subspan(count);
            turns_.turnDone();
        }
        batch_.clear();
    }

    void cutMember(const Batch::Member& member, std::span<const Clipped> kept, bool touches)
    {
        const auto chords = batch_.chordsOf(member);
        const ObjectView view = objects_[member.object];
        const bool filled = view.style().fill && view.path().hasArea();
        if (!filled && std::ranges::equal(chords, kept, {}, &Chord::segment, &Clipped::segment))
            return edit_.keep(member.object);
        if (!filled && kept.empty())
            return remove(member.object, touches);
        const Object object = view.copy();
        std::optional<AreaLeft> area;
        if (filled)
            area = areas_.left(object.path, object.style.fillRule, chords, border_);
        CutObject result = cutObject(object, options_, chords, kept, member.first, area, border_);
        if (result.whole)
            return edit_.keep(member.object);
        edit_.counts().dropped += result.dropped;
        if (result.left.empty())
            return remove(member.object, touches);
        const bool isPoints = touches && std::ranges::all_of(result.left, isOnlyPoints);
        edit_.cut(member.object, std::move(result));
        edit_.counts().touching += isPoints;
        edit_.counts().cut -= isPoints;
    }

    void remove(std::size_t object, bool touches)
    {
        edit_.remove(object);
        edit_.counts().touching += touches;
        edit_.counts().gone -= touches;
    }

    const Objects& objects_;
    CurvedBorder border_;
    const CutOptions options_;
    SomeEdit& edit_;
    ChordClipping clipping_;
    AreaCut areas_;
    Batch batch_;
    TurnProgress turns_; ///< a turn for each object
};

/// What becomes of each object, without a document around them.
class EachObject {
public:
    explicit EachObject(std::size_t objects) : results_(objects) {}

    static bool isLocked(std::size_t) { return false; }
    static bool isHidden(std::size_t) { return false; }
    void keep(std::size_t object) { results_[object].whole = true; }
    void remove(std::size_t) {}
    void cut(std::size_t object, CutObject result) { results_[object] = std::move(result); }
    CutCounts& counts() { return counts_; }
    std::vector<CutObject> take() { return std::move(results_); }

private:
    std::vector<CutObject> results_;
    CutCounts counts_;
};

/// Empty if the document cannot hold the groups.
std::optional<Cut> cutWith(Grouping grouping, const Document& document, const CutOptions& options,
                           const Follower& follower)
{
    CutEdit edit(document, grouping);
    Cutter(document.objects(), document.page(), options, edit, follower).cut();
    return edit.take();
}

} // namespace

void cutAt(CutOptions& options, const ClipWindows& windows, const Page& page)
{
    options.region = regionOf(windows, page);
    options.windows = windows;
    options.wideStroke = 1 / page.millimetresPerUnit();
}

CutOptions atPolygons(CutOptions options, const CurvedBorder& border, const Page& page)
{
    if (!border.isEmpty())
        options.region = withKeep(regionOf(border.polygons(), page), options.region.keep);
    return options;
}

Cut cut(const Document& document, const CutOptions& options, const Follower& follower)
{
    assert(options.clipAll);
    auto made = cutWith(Grouping::Yes, document, options, follower);
    if (!made)
        made = cutWith(Grouping::No, document, options, follower);
    cutImages(*made, document, options);
    return std::move(*made);
}

std::vector<CutObject> cutEach(const Objects& objects, const Page& page, const CutOptions& options)
{
    assert(options.clipAll);
    EachObject edit(objects.size());
    Cutter(objects, page, options, edit, {}).cut();
    return edit.take();
}

std::vector<Object> cutAlone(const Object& object, const CutOptions& options)
{
    assert(options.clipAll && options.tolerance > 0);
    std::vector<Chord> chords;
    CurvedBorder().flattenAlong(object.path, options.tolerance, chords);
    ChordClipping clipping(options);
    const auto kept = clipping.keptOf(chords);
    std::optional<AreaLeft> area;
    if (object.style.fill && object.path.hasArea())
        area = AreaCut(options.region).left(object.path, object.style.fillRule, chords);
    CutObject result = cutObject(object, options, chords, kept, 0, area);
    return result.whole ? std::vector{object} : std::move(result.left);
}

std::vector<std::uint32_t> sourcesOf(const Cut& cut, std::size_t objects)
{
    std::vector<std::uint32_t> sources;
    std::uint32_t next = 0;
    const auto unchangedUpTo = [&](std::size_t end) {
        while (next < end)
            sources.push_back(next++);
    };
    for (const Splice& splice : cut.edit.splices) {
        unchangedUpTo(splice.first);
        sources.insert(sources.end(), splice.added, splice.first);
        next += splice.removed;
    }
    unchangedUpTo(objects);
    return sources;
}

ObjectRanges leftBy(const Cut& cut, std::size_t objects)
{
    ObjectRanges left(ObjectRange{0, objects}), gone;
    for (const Splice& splice : cut.edit.splices)
        if (splice.added == 0)
            gone.insert({splice.first, splice.first + splice.removed});
    return without(left, gone);
}

} // namespace app
