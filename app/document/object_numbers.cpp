// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/object_numbers.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace app {
namespace {

bool keepsCount(const Splice& splice) { return splice.removed == splice.added; }

} // namespace

ObjectNumbers::ObjectNumbers(std::size_t objects) : numbers_(objects)
{
    std::iota(numbers_.begin(), numbers_.end(), 1U);
}

std::optional<ObjectNumbers::Changed> ObjectNumbers::after(const Edit& edit) const
{
    if (edit.moved.empty() && edit.numbers.empty() && std::ranges::all_of(edit.splices, keepsCount))
        return std::nullopt;
    const Numbers added = ofAdded(edit);
    Changed changed;
    std::size_t removed = 0;
    for (const Splice& splice : edit.splices)
        removed += splice.removed;
    Numbers& all = changed.numbers.numbers_;
    all.resize(numbers_.size() - removed + added.size());
    auto from = numbers_.begin();
    auto next = added.begin();
    auto to = all.begin();
    for (const Splice& splice : edit.splices) {
        const auto gone = numbers_.begin() + splice.first;
        to = std::copy(from, gone, to);
        to = std::copy_n(next, splice.added, to);
        next += splice.added;
        from = gone + splice.removed;
        for (auto number = gone; number != from; ++number)
            append(changed.removed, {*number, 1});
    }
    std::copy(from, numbers_.end(), to);
    return changed;
}

ObjectNumbers::Numbers ObjectNumbers::ofAdded(const Edit& edit) const
{
    Numbers added;
    added.reserve(edit.objects.size());
    for (const NumberRun& run : edit.numbers)
        for (std::uint32_t i = 0; i < run.count; ++i)
            added.push_back(run.first + i);
    if (edit.numbers.empty())
        appendSame(edit, added);
    assert(added.size() == edit.objects.size());
    if (std::ranges::find(added, 0U) == added.end())
        return added;
    std::uint32_t last = numbers_.empty() ? 0 : *std::ranges::max_element(numbers_);
    for (std::uint32_t& number : added)
        if (number == 0)
            number = ++last;
    return added;
}

/// The numbers of those that were there before; of others 0.
void ObjectNumbers::appendSame(const Edit& edit, Numbers& added) const
{
    const auto appendSome = [&](std::size_t first, std::size_t count) {
        const auto from = numbers_.begin() + std::ptrdiff_t(first);
        added.insert(added.end(), from, from + std::ptrdiff_t(count));
    };
    for (const NumberRun& run : edit.moved)
        if (run.first == NumberRun::none)
            added.resize(added.size() + run.count);
        else
            appendSome(run.first, run.count);
    if (!edit.moved.empty())
        return;
    for (const Splice& splice : edit.splices) {
        const std::size_t end = added.size() + splice.added;
        if (keepsCount(splice))
            appendSome(splice.first, splice.added);
        else if (splice.removed == 1 && splice.added > 0)
            appendSome(splice.first, 1); // its first piece
        added.resize(end);
    }
}

} // namespace app
