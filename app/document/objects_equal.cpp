// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/objects.h"

#include <algorithm>
#include <cstring>

namespace app {
namespace {

/// Whether two indices of different tables mean equal styles. Caches the last pair, as neighbours
/// mostly have the same styles.
class SameStyle {
public:
    SameStyle(const StyleTable& a, const StyleTable& b) : a_(a), b_(b) {}
    bool operator()(StyleIndex a, StyleIndex b)
    {
        if (&a_ == &b_ && a == b)
            return true;
        if (a != lastA_ || b != lastB_ || !same_) {
            lastA_ = a;
            lastB_ = b;
            same_ = a_[a] == b_[b];
        }
        return same_;
    }
    bool oneTable() const { return &a_ == &b_; }

private:
    const StyleTable &a_, &b_;
    StyleIndex lastA_ = 0, lastB_ = 0;
    bool same_ = false;
};

/// Objects of a block, from `first` on.
struct Run {
    const ObjectBlock& block;
    std::size_t first;
};

bool sameGeometry(const Run& a, const Run& b, std::size_t count)
{
    if (a.block.paths.empty() && b.block.paths.empty())
        return std::memcmp(&a.block.lines[a.first], &b.block.lines[b.first],
                           count * sizeof(clipping::Segment))
               == 0;
    for (std::size_t i = 0; i < count; ++i)
        if (!(a.block.path(a.first + i) == b.block.path(b.first + i)))
            return false;
    return true;
}

bool same(const Run& a, const Run& b, std::size_t count, SameStyle& sameStyle)
{
    if (&a.block == &b.block && a.first == b.first && sameStyle.oneTable())
        return true;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t x = a.first + i, y = b.first + i;
        if (!sameStyle(a.block.style(x), b.block.style(y))
            || a.block.isHidden(x) != b.block.isHidden(y)
            || !(a.block.particularsOf(x) == b.block.particularsOf(y)))
            return false;
    }
    return sameGeometry(a, b, count);
}

} // namespace

bool operator==(const Objects& a, const Objects& b)
{
    if (a.size() != b.size())
        return false;
    SameStyle sameStyle(a.styles(), b.styles());
    for (std::size_t i = 0, x = 0, y = 0; i < a.size();) {
        const Run one{*a.blocks_[x], i - a.first_[x]}, other{*b.blocks_[y], i - b.first_[y]};
        const std::size_t restOfOne = one.block.size() - one.first;
        const std::size_t restOfOther = other.block.size() - other.first;
        const std::size_t count = std::min(restOfOne, restOfOther);
        if (!same(one, other, count, sameStyle))
            return false;
        i += count;
        x += count == restOfOne;
        y += count == restOfOther;
    }
    return true;
}

} // namespace app
