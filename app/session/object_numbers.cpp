// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/object_numbers.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <optional>
#include <unordered_map>

namespace app {
namespace {

constexpr std::size_t mostSteps = 1000; // of which an undo restores the numbers

/// The same for an object that was moved in the painting order: its points are shared.
std::size_t keyOf(const ObjectView& object)
{
    const auto line = object.singleLine();
    if (!line)
        return std::hash<const void*>()(object.path().heapPart().address);
    std::size_t key = 0;
    for (const double value : {line->a.x, line->a.y, line->b.x, line->b.y})
        key = key * 31 + std::hash<double>()(value);
    return key;
}

bool keepsCount(const Splice& splice) { return splice.removed == splice.added; }

/// The objects that a change removes and may add elsewhere, as numbered among the removed ones.
class Moved {
public:
    Moved(const Objects& objects, std::span<const Splice> splices)
    {
        const bool adds = std::ranges::any_of(
            splices, [](const Splice& splice) { return !keepsCount(splice) && splice.added > 0; });
        for (std::size_t old = 0; const Splice& splice : splices) {
            taken_.resize(old + splice.removed, keepsCount(splice));
            for (std::size_t i = 0; adds && !keepsCount(splice) && i < splice.removed; ++i)
                byKey_.emplace(keyOf(objects[splice.first + i]), old + i);
            old += splice.removed;
        }
    }
    std::optional<std::size_t> take(const Objects& objects, std::size_t added)
    {
        if (byKey_.empty())
            return std::nullopt;
        const auto found = byKey_.find(keyOf(objects[added]));
        if (found == byKey_.end())
            return std::nullopt;
        const std::size_t old = found->second;
        byKey_.erase(found);
        taken_[old] = true;
        return old;
    }
    bool takeOld(std::size_t old) ///< false: it was taken already
    {
        const bool isFree = !taken_[old];
        taken_[old] = true;
        return isFree;
    }

private:
    std::unordered_multimap<std::size_t, std::size_t> byKey_;
    std::vector<bool> taken_;
};

} // namespace

ObjectNumbers::ObjectNumbers(EditedDocument& document) : document_(document)
{
    connect(&document, &EditedDocument::changed, this, &ObjectNumbers::follow);
    begin();
}

void ObjectNumbers::begin()
{
    before_ = document_.now();
    numbers_.resize(before_.objects().size());
    std::iota(numbers_.begin(), numbers_.end(), 1U);
    done_.clear();
    undone_.clear();
}

// An undo is known by its splices: they are the inverse of those of the last change. Objects that a
// splice replaces one for one are the same ones, changed.
void ObjectNumbers::follow(const DocumentChange& change)
{
    if (change.everything)
        return begin();
    if (change.again && numbers_.size() != document_.now().objects().size() && !done_.empty()) {
        replace(inverse(done_.back().splices), done_.back().before); // it was not done after all
        done_.pop_back();
    }
    if (!change.splices.empty() && !std::ranges::all_of(change.splices, keepsCount)) {
        const std::vector<Splice> splices(change.splices.begin(), change.splices.end());
        if (!done_.empty() && inverse(done_.back().splices) == splices) {
            replace(splices, done_.back().before);
            undone_.push_back(std::move(done_.back()));
            done_.pop_back();
        } else if (!undone_.empty() && undone_.back().splices == splices) {
            replace(splices, undone_.back().after);
            done_.push_back(std::move(undone_.back()));
            undone_.pop_back();
        } else {
            Step step{splices, removedBy(splices), {}};
            step.after = newNumbers(splices, step.before);
            replace(splices, step.after);
            undone_.clear();
            done_.push_back(std::move(step));
            if (done_.size() > mostSteps)
                done_.pop_front();
        }
    }
    before_ = document_.now();
}

ObjectNumbers::Numbers ObjectNumbers::removedBy(std::span<const Splice> splices) const
{
    Numbers removed;
    for (const Splice& splice : splices)
        removed.insert(removed.end(), numbers_.begin() + splice.first,
                       numbers_.begin() + splice.first + splice.removed);
    return removed;
}

/// Of all objects that the splices add: the number that the object had, be it changed in its place,
/// moved to another, or cut; else a new one.
ObjectNumbers::Numbers ObjectNumbers::newNumbers(std::span<const Splice> splices,
                                                 const Numbers& removed) const
{
    Moved moved(before_.objects(), splices);
    std::uint32_t last = numbers_.empty() ? 0 : *std::ranges::max_element(numbers_);
    Numbers added;
    std::size_t old = 0, now = 0; // of the first object that the splice removes, and adds
    std::size_t kept = 0;         // what lies below it and stays
    std::size_t below = 0;
    for (const Splice& splice : splices) {
        kept += splice.first - below;
        below = splice.first + splice.removed;
        for (std::size_t i = 0; i < splice.added; ++i) {
            const auto from = keepsCount(splice)
                                  ? std::optional(old + i)
                                  : moved.take(document_.now().objects(), kept + now + i);
            added.push_back(from ? removed[*from] : 0);
        }
        old += splice.removed;
        now += splice.added;
    }
    old = now = 0;
    for (const Splice& splice : splices) { // the first piece of what was cut is that object
        const auto end = added.begin() + std::ptrdiff_t(now + splice.added);
        const auto piece = std::find(added.begin() + std::ptrdiff_t(now), end, 0U);
        if (piece != end && splice.removed > 0 && moved.takeOld(old))
            *piece = removed[old];
        old += splice.removed;
        now += splice.added;
    }
    for (std::uint32_t& number : added)
        if (number == 0)
            number = ++last;
    return added;
}

void ObjectNumbers::replace(std::span<const Splice> splices, const Numbers& added)
{
    if (splices.size() == 1) { // what lies below is not copied
        const Splice& one = splices.front();
        const auto at = numbers_.erase(numbers_.begin() + one.first,
                                       numbers_.begin() + one.first + one.removed);
        numbers_.insert(at, added.begin(), added.end());
        return;
    }
    Numbers all;
    all.reserve(numbers_.size() + added.size());
    auto from = numbers_.begin();
    auto next = added.begin();
    for (const Splice& splice : splices) {
        all.insert(all.end(), from, numbers_.begin() + splice.first);
        all.insert(all.end(), next, next + splice.added);
        next += splice.added;
        from = numbers_.begin() + splice.first + splice.removed;
    }
    all.insert(all.end(), from, numbers_.end());
    numbers_ = std::move(all);
}

} // namespace app

#include "moc_object_numbers.cpp"
