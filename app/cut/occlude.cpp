// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/occlude.h"

#include "app/base/progress.h"
#include "app/cut/area_outline.h"
#include "app/cut/covering.h"
#include "app/cut/curved_border.h"
#include "app/cut/cut_edit.h"

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>
#include <unordered_map>

namespace app {
namespace {

constexpr std::uint8_t opaque = 255;

class Occlusion {
public:
    Occlusion(const Document& document, const CutOptions& options, const Follower& follower)
        : document_(document), options_(options), follower_(follower), edit_(document, Grouping::No)
    {
        if (!(options_.tolerance > 0))
            options_.tolerance = usualTolerance(document.page());
        options_.region = {};
    }

    Cut made()
    {
        border_.emplace(borders(), options_.tolerance, document_.page(), options_.coincident);
        border_->divideFor(document_.objects(), options_.tolerance, follower_.stop);
        auto all = areas();
        const std::size_t number = all.size();
        Covering covering(std::move(all), follower_.stop);
        TurnProgress turns(follower_, turnsFor(number));
        document_.objects().forEach(0, document_.objects().size(),
                                    [&](std::size_t i, const ObjectView& object) {
                                        if (turns.stopped())
                                            return;
                                        if (reached(i))
                                            cut(i, object, covering);
                                        turns.turnDone(turnsOf(i, number));
                                    });
        return *edit_.take(); // there are no groups, so it is never empty
    }

private:
    // An object takes as long as the areas above it are many.
    double turnsOf(std::size_t object, std::size_t areas) const
    {
        return 1 + double(areas - notAbove_[object]);
    }
    double turnsFor(std::size_t areas) const
    {
        double turns = 0;
        for (std::size_t i = 0; i < notAbove_.size(); ++i)
            turns += turnsOf(i, areas);
        return turns;
    }

    // All areas that cover something, and how many of them are not above each object.
    std::vector<clipping::Area> areas()
    {
        std::vector<clipping::Area> areas;
        document_.objects().forEach(0, document_.objects().size(),
                                    [&](std::size_t i, const ObjectView& object) {
                                        if (covers(i, object))
                                            areas.push_back(areaOf(i, object));
                                        notAbove_.push_back(std::uint32_t(areas.size()));
                                    });
        return areas;
    }

    bool covers(std::size_t i, const ObjectView& object)
    {
        const auto& fill = object.style().fill;
        return fill && fill->alpha == opaque && object.path().hasArea() && !edit_.isHidden(i);
    }

    // Each once: there may be thousands of copies.
    std::vector<Path> borders()
    {
        if (CurvedBorder::sidesFor(document_.objects()) == CurvedBorder::Sides::No)
            return {};
        std::vector<Path> paths;
        std::multimap<std::tuple<double, double, std::size_t>, std::size_t> known;
        document_.objects().forEach(
            0, document_.objects().size(), [&](std::size_t i, const ObjectView& object) {
                if (!covers(i, object))
                    return;
                const Point start = object.path().subpaths().front().start;
                const auto [same, end] =
                    known.equal_range({start.x, start.y, object.path().pointCount()});
                if (std::any_of(same, end,
                                [&](const auto& at) { return paths[at.second] == object.path(); }))
                    return;
                known.emplace(std::tuple(start.x, start.y, object.path().pointCount()),
                              paths.size());
                paths.push_back(object.path());
            });
        return paths;
    }

    clipping::Area areaOf(std::size_t i, const ObjectView& object)
    {
        chords_.clear();
        border_->flattenAlong(object.path(), options_.tolerance, chords_);
        if (!object.path().straight())
            known_.emplace(i, chords_);
        return flatAreaOf(object.path().subpaths(), object.style().fillRule, chords_).area;
    }

    void takeChordsOf(std::size_t i, const ObjectView& object)
    {
        chords_.clear();
        if (auto known = known_.extract(i))
            chords_ = std::move(known.mapped());
        else
            border_->flattenAlong(object.path(), options_.tolerance, chords_);
    }

    bool reached(std::size_t i)
    {
        const bool locked = options_.leaveLocked && edit_.isLocked(i);
        const bool hidden = !locked && edit_.isHidden(i);
        edit_.counts().leftLocked += locked;
        edit_.counts().leftHidden += hidden;
        return !locked && !hidden;
    }

    void cut(std::size_t i, const ObjectView& view, Covering& covering)
    {
        const bool filled = view.style().fill.has_value();
        edit_.counts().fillsRemoved += filled && view.path().hasArea();
        if (filled && !view.style().stroke)
            return edit_.remove(i);
        takeChordsOf(i, view);
        const auto visible = covering.visible(chords_, notAbove_[i]);
        edit_.counts().segmentsBefore += chords_.size();
        edit_.counts().segmentsAfter += visible.size();
        Object object = view.copy();
        object.style.fill.reset();
        CutObject result = cutObject(object, options_, chords_, visible, 0, std::nullopt, *border_);
        edit_.counts().dropped += result.dropped;
        if (result.whole)
            return filled ? edit_.change(i, object) : edit_.keep(i);
        if (result.left.empty())
            return edit_.remove(i);
        edit_.cut(i, std::move(result));
    }

    const Document& document_;
    CutOptions options_;
    const Follower& follower_;
    CutEdit edit_;
    std::optional<CurvedBorder> border_;
    std::vector<std::uint32_t> notAbove_;
    std::unordered_map<std::size_t, std::vector<Chord>> known_; ///< of curved areas, until cut
    std::vector<Chord> chords_;
};

} // namespace

Cut occlude(const Document& document, const CutOptions& options, const Follower& follower)
{
    return Occlusion(document, options, follower).made();
}

} // namespace app
