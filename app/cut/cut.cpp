// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/cut.h"

#include "app/cut/cut_object.h"
#include "app/cut/fresh_ids.h"
#include "clipping/outside.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace app {
namespace {

using clipping::Clipped;

constexpr std::size_t chordsAtOnce = 65'536; // of whole objects; a single object may have more

bool notFinite(const Clipped& piece)
{
    const auto& [a, b] = piece.segment;
    return !std::isfinite(a.x + a.y + b.x + b.y); // coordinates are far below overflow
}

// The chords of many objects in one array, so that one call of the algorithm clips them all.
class Batch {
public:
    struct Member {
        std::size_t object;
        std::size_t first, end; ///< its chords in the array
    };

    void add(std::size_t number, const ObjectView& object, double tolerance)
    {
        const std::size_t first = chords_.size();
        if (const auto line = object.singleLine())
            chords_.push_back({*line, 0, 0, 1});
        else
            flatten(object.path(), tolerance, chords_);
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
class Clipping {
public:
    explicit Clipping(const CutOptions& options) : options_(options)
    {
        folding_.start(options.region, options.clipAll);
    }

    std::span<const Clipped> keptOf(std::span<const Chord> chords)
    {
        lines_.resize(chords.size());
        std::ranges::transform(chords, lines_.begin(), &Chord::segment);
        kept_.clear();
        if (options_.region.everything())
            keepAll();
        else if (const auto window = options_.region.single())
            clipAt(*window);
        else
            folding_.fold(lines_, 0, kept_);
        if (!options_.keepContacts)
            std::erase_if(kept_, [&](const Clipped& piece) {
                const auto& [a, b] = piece.segment;
                return a == b && lines_[piece.source].a != lines_[piece.source].b;
            });
        return kept_;
    }

private:
    void keepAll()
    {
        for (std::size_t i = 0; i < lines_.size(); ++i)
            kept_.push_back({lines_[i], std::uint32_t(i), {}});
    }

    void clipAt(const clipping::Window& window)
    {
        kept_.resize(lines_.size());
        kept_.resize(options_.clipAll(lines_, window, kept_));
        std::erase_if(kept_, notFinite); // a published form may return anything
        if (options_.region.keep == Keep::Inside)
            return;
        outside_.resize(lines_.size() + kept_.size());
        outside_.resize(clipping::outsideAll(lines_, kept_, outside_));
        std::swap(kept_, outside_);
    }

    const CutOptions& options_;
    RegionClipping folding_;
    std::vector<clipping::Segment> lines_;
    std::vector<Clipped> kept_, outside_;
};

class Cutter {
public:
    Cutter(const Document& document, const CutOptions& options)
        : document_(document), options_(options),
          tolerance_(options.tolerance > 0 ? options.tolerance : usualTolerance(document.page())),
          hidden_(document.containers().hiddenRanges()),
          locked_(document.containers().lockedRanges()), clipping_(options)
    {
        cut_.edit.objects = objects().slice(0, 0);
    }

    Cut cut()
    {
        objects().forEach(0, objects().size(), [&](std::size_t i, const ObjectView& object) {
            if (!reached(i, object))
                return;
            batch_.add(i, object, tolerance_);
            if (batch_.chords().size() >= chordsAtOnce)
                cutBatch();
        });
        cutBatch();
        if (!cut_.edit.splices.empty())
            cut_.edit.containers = document_.containers().spliced(cut_.edit.splices);
        return std::move(cut_);
    }

private:
    const Objects& objects() const { return document_.objects(); }

    bool reached(std::size_t i, const ObjectView& object)
    {
        if (options_.scope == CutScope::Everything)
            return true;
        const bool locked = locked_.contains(i), hidden = object.hidden() || hidden_.contains(i);
        cut_.counts.leftLocked += locked;
        cut_.counts.leftHidden += hidden && !locked;
        return !locked && !hidden;
    }

    void cutBatch()
    {
        std::span<const Clipped> kept = clipping_.keptOf(batch_.chords());
        cut_.counts.segmentsBefore += batch_.chords().size();
        cut_.counts.segmentsAfter += kept.size();
        for (const Batch::Member& member : batch_.members()) {
            const auto end = std::ranges::find_if(
                kept, [&](const Clipped& piece) { return piece.source >= member.end; });
            const auto count = std::size_t(end - kept.begin());
            cutMember(member, kept.first(count));
            kept = kept.subspan(count);
        }
        batch_.clear();
    }

    void cutMember(const Batch::Member& member, std::span<const Clipped> kept)
    {
        const auto chords = batch_.chordsOf(member);
        const ObjectView view = objects()[member.object];
        const bool filled = view.style().fill && view.path().hasArea();
        if (!filled && std::ranges::equal(chords, kept, {}, &Chord::segment, &Clipped::segment))
            return noteWhole(member.object);
        if (!filled && kept.empty())
            return remove(member.object);
        const Object object = view.copy();
        std::optional<AreaLeft> area;
        if (filled)
            area = areas_.left(object.path, object.style.fillRule, chords);
        const CutObject result =
            cutObject(object, tolerance_, chords, kept, member.first, options_.region, area);
        if (result.whole)
            return noteWhole(member.object);
        if (result.left.empty())
            return remove(member.object);
        ++cut_.counts.cut;
        cut_.counts.hidden += object.hidden || hidden_.contains(member.object);
        cut_.counts.opened += result.opened;
        cut_.edit.splices.push_back(
            {std::uint32_t(member.object), 1, std::uint32_t(result.left.size())});
        for (std::size_t i = 0; i < result.left.size(); ++i) {
            Object left = result.left[i];
            if (i > 0)
                left.particulars.id = ids_.next(object.particulars.id);
            cut_.edit.objects.append(left);
        }
    }

    void noteWhole(std::size_t object)
    {
        ++cut_.counts.whole;
        cut_.counts.hidden += objects()[object].hidden() || hidden_.contains(object);
    }

    void remove(std::size_t object)
    {
        ++cut_.counts.gone;
        auto& splices = cut_.edit.splices;
        if (!splices.empty() && splices.back().added == 0
            && splices.back().first + splices.back().removed == object)
            ++splices.back().removed;
        else
            splices.push_back({std::uint32_t(object), 1, 0});
    }

    const Document& document_;
    const CutOptions& options_;
    const double tolerance_;
    const ObjectRanges hidden_, locked_;
    Clipping clipping_;
    AreaCut areas_{options_.region};
    FreshIds ids_{document_};
    Batch batch_;
    Cut cut_;
};

} // namespace

Cut cut(const Document& document, const CutOptions& options)
{
    assert(options.clipAll);
    return Cutter(document, options).cut();
}

std::vector<Object> cutAlone(const Object& object, const CutOptions& options)
{
    assert(options.clipAll && options.tolerance > 0);
    std::vector<Chord> chords;
    flatten(object.path, options.tolerance, chords);
    Clipping clipping(options);
    const auto kept = clipping.keptOf(chords);
    std::optional<AreaLeft> area;
    if (object.style.fill && object.path.hasArea())
        area = AreaCut(options.region).left(object.path, object.style.fillRule, chords);
    CutObject result = cutObject(object, options.tolerance, chords, kept, 0, options.region, area);
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

} // namespace app
