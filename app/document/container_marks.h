// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/shared.h"
#include "app/document/container_table.h"

#include <cstddef>
#include <span>
#include <vector>

namespace app {

/// The opening or closing of a container in painting order, followed by `objects` objects before
/// the next mark. After an opening mark these objects belong to the container; after a closing mark
/// they belong to its parent.
struct ContainerMark {
    std::uint32_t id : 31;
    std::uint32_t closes : 1;
    std::uint32_t objects;
    friend bool operator==(const ContainerMark&, const ContainerMark&) = default;
};

/// Marks in painting order: the container tree written as brackets. Copies share the blocks of
/// marks.
class ContainerMarks {
public:
    static constexpr std::size_t mostInBlock = 256;
    /// A position in the sequence, valid until the next change.
    struct At {
        std::size_t block = 0, index = 0;
        friend bool operator==(const At&, const At&) = default;
    };

    ContainerMarks() = default;
    explicit ContainerMarks(std::span<const ContainerMark> marks) { replace({}, {}, marks); }

    std::size_t objects() const { return objects_; } ///< fewer than 2^32
    At begin() const { return {}; }
    At end() const { return {blocks_.size(), 0}; }
    At next(const At& at) const;
    At previous(const At& at) const; ///< not for `begin()`
    const ContainerMark& operator[](const At& at) const;

    std::size_t objectsBefore(const At& at) const; ///< O(mostInBlock)
    /// The last mark before the object; the object must exist.
    At before(std::size_t object) const;
    /// The last mark for which `holds` is true. `holds` must be true for the first mark, and once
    /// false stay false. O(log marks).
    template <class Holds>
    At lastWhere(const Holds& holds) const;

    /// Replaces the marks [from, to) by `marks`. O(marks replaced and added + blocks).
    void replace(const At& from, const At& to, std::span<const ContainerMark> marks);

    /// The heap bytes that this object keeps alive and `other` does not.
    std::size_t bytesNotIn(const ContainerMarks& other) const;

    /// The number of marks and blocks that this thread has visited. Tests use it to count steps.
    inline static thread_local std::size_t steps = 0;

private:
    using Block = std::vector<ContainerMark>; // never empty

    void exchangeBlocks(std::size_t first, std::size_t last, std::vector<Shared<Block>> blocks);

    std::vector<Shared<Block>> blocks_;
    std::vector<std::uint32_t> before_; ///< objects before each block
    std::size_t objects_ = 0;
};

template <class Holds>
ContainerMarks::At ContainerMarks::lastWhere(const Holds& holds) const
{
    const auto lastIn = [&](std::size_t count, const auto& mark) {
        std::size_t last = 0;
        for (std::size_t end = count; end - last > 1; ++steps) {
            const std::size_t middle = last + (end - last) / 2;
            (holds(mark(middle)) ? last : end) = middle;
        }
        return last;
    };
    const std::size_t block =
        lastIn(blocks_.size(), [&](std::size_t i) { return blocks_[i]->front(); });
    const Block& marks = *blocks_[block];
    return {block, lastIn(marks.size(), [&](std::size_t i) { return marks[i]; })};
}

} // namespace app
