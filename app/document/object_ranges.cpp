// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/object_ranges.h"

#include <algorithm>

namespace app {

ObjectRanges::ObjectRanges(std::initializer_list<std::size_t> objects)
{
    for (const std::size_t object : objects)
        insert(object);
}

bool ObjectRanges::contains(std::size_t object) const
{
    const auto at = std::ranges::upper_bound(ranges_, object, {}, &ObjectRange::end);
    return at != ranges_.end() && at->first <= object;
}

bool ObjectRanges::contains(const ObjectRange& range) const
{
    if (range.empty())
        return true;
    const auto at = std::ranges::upper_bound(ranges_, range.first, {}, &ObjectRange::end);
    return at != ranges_.end() && at->first <= range.first && range.end <= at->end;
}

bool ObjectRanges::intersects(const ObjectRange& range) const
{
    const auto at = std::ranges::upper_bound(ranges_, range.first, {}, &ObjectRange::end);
    return !range.empty() && at != ranges_.end() && at->first < range.end;
}

bool ObjectRanges::insert(std::size_t object)
{
    const std::size_t before = size_;
    insert(ObjectRange{object, object + 1});
    return size_ != before;
}

bool ObjectRanges::erase(std::size_t object)
{
    const std::size_t before = size_;
    erase(ObjectRange{object, object + 1});
    return size_ != before;
}

// Merges `range` with the ranges that it overlaps or adjoins.
void ObjectRanges::insert(const ObjectRange& range)
{
    if (range.empty())
        return;
    const auto from = std::ranges::lower_bound(ranges_, range.first, {}, &ObjectRange::end);
    const auto to =
        std::ranges::upper_bound(from, ranges_.end(), range.end, {}, &ObjectRange::first);
    ObjectRange joined = range;
    for (auto old = from; old != to; ++old) {
        joined = {std::min(joined.first, old->first), std::max(joined.end, old->end)};
        size_ -= old->size();
    }
    size_ += joined.size();
    if (from == to) {
        ranges_.insert(from, joined);
        return;
    }
    *from = joined;
    ranges_.erase(from + 1, to);
}

void ObjectRanges::erase(const ObjectRange& range)
{
    if (range.empty())
        return;
    const auto from = std::ranges::upper_bound(ranges_, range.first, {}, &ObjectRange::end);
    const auto to =
        std::ranges::lower_bound(from, ranges_.end(), range.end, {}, &ObjectRange::first);
    if (from == to)
        return;
    const ObjectRange below{from->first, range.first}, above{range.end, (to - 1)->end};
    for (auto old = from; old != to; ++old)
        size_ -= old->size();
    size_ += below.size() + above.size();
    auto at = ranges_.erase(from, to);
    if (!above.empty())
        at = ranges_.insert(at, above);
    if (!below.empty())
        ranges_.insert(at, below);
}

ObjectRanges ObjectRanges::shifted(std::size_t first, std::size_t removed, std::size_t added) const
{
    ObjectRanges all;
    for (const ObjectRange& range : ranges_) {
        all.append({range.first, std::min(range.end, first)});
        const std::size_t above = std::max(range.first, first + removed);
        if (above < range.end)
            all.append({above - removed + added, range.end - removed + added});
    }
    return all;
}

// Appends `range`, which must not start below the last range.
void ObjectRanges::append(const ObjectRange& range)
{
    if (range.empty())
        return;
    if (ranges_.empty() || ranges_.back().end < range.first) {
        ranges_.push_back(range);
        size_ += range.size();
    } else if (ranges_.back().end < range.end) {
        size_ += range.end - ranges_.back().end;
        ranges_.back().end = range.end;
    }
}

ObjectRanges united(const ObjectRanges& a, const ObjectRanges& b)
{
    std::vector<ObjectRange> both;
    std::ranges::merge(a.ranges_, b.ranges_, std::back_inserter(both), {}, &ObjectRange::first,
                       &ObjectRange::first);
    ObjectRanges all;
    for (const ObjectRange& range : both)
        all.append(range);
    return all;
}

ObjectRanges common(const ObjectRanges& a, const ObjectRanges& b)
{
    ObjectRanges all;
    for (auto i = a.ranges_.begin(), j = b.ranges_.begin();
         i != a.ranges_.end() && j != b.ranges_.end();) {
        all.append({std::max(i->first, j->first), std::min(i->end, j->end)});
        if (i->end < j->end)
            ++i;
        else
            ++j;
    }
    return all;
}

ObjectRanges without(const ObjectRanges& a, const ObjectRanges& b)
{
    ObjectRanges all;
    auto hole = b.ranges_.begin();
    for (ObjectRange rest : a.ranges_) {
        while (hole != b.ranges_.end() && hole->end <= rest.first)
            ++hole;
        for (auto i = hole; i != b.ranges_.end() && i->first < rest.end; ++i) {
            all.append({rest.first, i->first});
            rest.first = i->end;
        }
        all.append(rest);
    }
    return all;
}

namespace {

// Iterates over splices, from the lowest to the highest.
class Passing {
public:
    explicit Passing(std::span<const Splice> splices) : left_(splices) {}

    /// The first splice that changes numbers and does not lie entirely below `object`; null if
    /// none.
    const Splice* nextFrom(std::size_t object)
    {
        while (!left_.empty()) {
            const Splice& s = left_.front();
            if (s.removed != s.added && s.first + s.removed > object)
                return &s;
            shift_ += s.added;
            shift_ -= s.removed;
            left_ = left_.subspan(1);
        }
        return nullptr;
    }
    /// The object's number after all splices passed so far.
    std::size_t shifted(std::size_t object) const { return object + shift_; }

private:
    std::span<const Splice> left_;
    std::size_t shift_ = 0; // modulo 2^64
};

} // namespace

ObjectRanges followed(const ObjectRanges& objects, std::span<const Splice> splices)
{
    Passing passing(splices);
    ObjectRanges result;
    for (const ObjectRange& range : objects.ranges())
        for (std::size_t at = range.first; at < range.end;) {
            const Splice* next = passing.nextFrom(at);
            const std::size_t end =
                next ? std::clamp<std::size_t>(next->first, at, range.end) : range.end;
            result.insert(ObjectRange{passing.shifted(at), passing.shifted(end)});
            at = end == range.end ? end : std::max(end, std::size_t(next->first) + next->removed);
        }
    return result;
}

} // namespace app
