// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <span>
#include <vector>

namespace app {

/// Consecutive objects in painting order: numbers from `first` on, before `end`.
struct ObjectRange {
    std::size_t first = 0, end = 0;

    bool empty() const { return first >= end; }
    std::size_t size() const { return empty() ? 0 : end - first; }
    friend bool operator==(const ObjectRange&, const ObjectRange&) = default;
};

/// A set of objects, by number, stored as ranges: all objects of a document are a single range. The
/// ranges ascend, and at least one number lies between two ranges.
class ObjectRanges {
public:
    class Iterator;

    ObjectRanges() = default;
    ObjectRanges(std::initializer_list<std::size_t> objects);
    explicit ObjectRanges(const ObjectRange& range) { append(range); }

    bool empty() const { return ranges_.empty(); }
    std::size_t size() const { return size_; } ///< the number of objects
    bool contains(std::size_t object) const;
    bool contains(const ObjectRange& range) const;   ///< all of it; an empty one: true
    bool intersects(const ObjectRange& range) const; ///< some of it
    std::size_t first() const { return ranges_.front().first; } ///< undefined if empty
    std::size_t last() const { return ranges_.back().end - 1; } ///< undefined if empty

    bool insert(std::size_t object); ///< false if it was already in the set
    bool erase(std::size_t object);  ///< false if it was not in the set
    void insert(const ObjectRange& range);
    void erase(const ObjectRange& range);

    /// The set after the objects [first, first + removed) are replaced by `added` new ones. Neither
    /// the removed nor the new objects are in the result.
    ObjectRanges shifted(std::size_t first, std::size_t removed, std::size_t added) const;

    std::span<const ObjectRange> ranges() const { return ranges_; }
    Iterator begin() const; ///< visits each object, ascending
    Iterator end() const;

    friend ObjectRanges united(const ObjectRanges& a, const ObjectRanges& b);  ///< in a or b
    friend ObjectRanges common(const ObjectRanges& a, const ObjectRanges& b);  ///< in a and b
    friend ObjectRanges without(const ObjectRanges& a, const ObjectRanges& b); ///< in a, not in b
    friend bool operator==(const ObjectRanges&, const ObjectRanges&) = default;

private:
    void append(const ObjectRange& range);

    std::vector<ObjectRange> ranges_;
    std::size_t size_ = 0;
};

ObjectRanges united(const ObjectRanges& a, const ObjectRanges& b);
ObjectRanges common(const ObjectRanges& a, const ObjectRanges& b);
ObjectRanges without(const ObjectRanges& a, const ObjectRanges& b);

/// Visits the objects in ascending order.
class ObjectRanges::Iterator {
public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = std::size_t;
    using difference_type = std::ptrdiff_t;
    using pointer = const std::size_t*;
    using reference = std::size_t;

    Iterator() = default;
    explicit Iterator(std::span<const ObjectRange> ranges)
        : ranges_(ranges), object_(ranges.empty() ? 0 : ranges.front().first)
    {
    }

    std::size_t operator*() const { return object_; }
    Iterator& operator++()
    {
        if (++object_ == ranges_.front().end)
            *this = Iterator(ranges_.subspan(1));
        return *this;
    }
    Iterator operator++(int)
    {
        const Iterator before = *this;
        ++*this;
        return before;
    }
    friend bool operator==(const Iterator& a, const Iterator& b)
    {
        return a.object_ == b.object_ && a.ranges_.size() == b.ranges_.size();
    }

private:
    std::span<const ObjectRange> ranges_; ///< from the range that contains object_ on
    std::size_t object_ = 0;
};

inline ObjectRanges::Iterator ObjectRanges::begin() const { return Iterator(ranges_); }
inline ObjectRanges::Iterator ObjectRanges::end() const { return {}; }

/// Replaces `removed` objects, from number `first` on, by `added` objects.
struct Splice {
    std::uint32_t first = 0, removed = 0, added = 0;
    friend bool operator==(const Splice&, const Splice&) = default;
};

/// The set `objects` in the numbering after the splices (ascending, in the old numbering). It
/// contains neither removed nor added objects, except where a splice removes as many as it adds:
/// these count as the same objects, changed. O(ranges + splices).
ObjectRanges followed(const ObjectRanges& objects, std::span<const Splice> splices);

} // namespace app
