// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/followed_ranges.h"

#include <algorithm>

namespace app {
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
