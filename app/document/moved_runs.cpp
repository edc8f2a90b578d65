// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/moved_runs.h"

#include <algorithm>
#include <numeric>

namespace app {
namespace {

constexpr std::size_t fewObjects = 64; // copied one by one

// The first range that ends above the object.
auto rangeAbove(const ObjectRanges& objects, std::size_t object)
{
    return std::ranges::upper_bound(objects.ranges(), object, {}, &ObjectRange::end);
}

/// The greatest sum of weights below an index, and where it is from.
class Maxima {
public:
    explicit Maxima(std::size_t size) : best_(size + 1) {}
    struct Best {
        std::size_t sum = 0, run = none;
    };
    static constexpr std::size_t none = ~std::size_t(0);
    Best below(std::size_t index) const
    {
        Best best;
        for (; index > 0; index -= index & (~index + 1))
            if (best_[index].sum > best.sum)
                best = best_[index];
        return best;
    }
    void put(std::size_t index, const Best& best)
    {
        for (++index; index < best_.size(); index += index & (~index + 1))
            if (best.sum > best_[index].sum)
                best_[index] = best;
    }

private:
    std::vector<Best> best_;
};

/// The runs that keep their order and together have the most objects.
std::vector<bool> staying(std::span<const MovedRun> runs)
{
    std::vector<std::size_t> ranks(runs.size()), order(runs.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::sort(order, {}, [&](std::size_t i) { return runs[i].objects.first; });
    for (std::size_t i = 0; i < order.size(); ++i)
        ranks[order[i]] = i;
    Maxima maxima(runs.size());
    std::vector<std::size_t> before(runs.size(), Maxima::none);
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (runs[i].added)
            continue;
        const Maxima::Best best = maxima.below(ranks[i]);
        before[i] = best.run;
        maxima.put(ranks[i], {best.sum + runs[i].objects.size(), i});
    }
    std::vector<bool> stays(runs.size());
    for (auto i = maxima.below(runs.size()).run; i != Maxima::none; i = before[i])
        stays[i] = true;
    return stays;
}

void append(Objects& all, const Objects& from, const ObjectRange& range)
{
    if (range.size() > fewObjects)
        return all.append(from.slice(range.first, range.size()));
    from.forEach(range.first, range.size(),
                 [&](std::size_t, const ObjectView& object) { all.append(object.row()); });
}

// Inserts those of the run that are chosen, at the run's new place.
void follow(const ObjectRanges& chosen, const ObjectRange& run, std::size_t at, ObjectRanges& into)
{
    for (auto range = rangeAbove(chosen, run.first);
         range != chosen.ranges().end() && range->first < run.end; ++range)
        into.insert(ObjectRange{std::max(range->first, run.first) - run.first + at,
                                std::min(range->end, run.end) - run.first + at});
}

} // namespace

bool meets(const ObjectRanges& objects, const ObjectRange& range)
{
    const auto above = rangeAbove(objects, range.first);
    return above != objects.ranges().end() && above->first < range.end;
}

ObjectRanges within(const ObjectRanges& objects, const ObjectRange& range)
{
    ObjectRanges result;
    follow(objects, range, range.first, result);
    return result;
}

MovedObjects objectsMoved(const Objects& objects, const Objects& added,
                          std::span<const MovedRun> runs, const ObjectRanges& chosen)
{
    const std::vector<bool> stays = staying(runs);
    MovedObjects moved;
    moved.objects = objects.slice(0, 0);
    std::size_t at = 0, passed = 0, coming = 0; // passed: objects in their old places
    const auto close = [&](std::size_t until) {
        if (until > passed || coming > 0)
            moved.splices.push_back({std::uint32_t(passed), std::uint32_t(until - passed),
                                     std::uint32_t(std::exchange(coming, 0))});
    };
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const ObjectRange& run = runs[i].objects;
        if (stays[i]) {
            close(run.first);
            passed = run.end;
        } else {
            append(moved.objects, runs[i].added ? added : objects, run);
            app::append(moved.moved, {runs[i].added ? NumberRun::none : std::uint32_t(run.first),
                                      std::uint32_t(run.size())});
            coming += run.size();
        }
        if (runs[i].added)
            moved.added.insert(ObjectRange{at, at + run.size()});
        else
            follow(chosen, run, at, moved.chosen);
        at += run.size();
    }
    close(objects.size());
    return moved;
}

} // namespace app
