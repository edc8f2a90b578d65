// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_ranges.h"
#include "app/document/object_view.h"

#include <memory>

namespace app {

/// Objects in painting order (fewer than 2^32), stored in blocks that documents, snapshots and the
/// history share. Copying costs a list of 12 bytes for each block, reading an object O(log blocks);
/// a splice copies the blocks it touches. Copies and slices also share the style table, which only
/// grows.
class Objects {
public:
    std::size_t size() const
    {
        return blocks_.empty() ? 0 : first_.back() + blocks_.back()->size();
    }
    bool empty() const { return blocks_.empty(); }
    ObjectView operator[](std::size_t i) const;

    // A style of another table is added to `styles()`.
    void append(const Object& object);
    void append(const ObjectRow& row);
    void appendLine(const clipping::Segment& line, const StyleEntry& style); ///< without an Object
    void append(const Objects& more); ///< shares whole blocks
    StyleTable& styles();
    const StyleTable& styles() const;
    /// Replaces the shared style table by a copy with the same indices: styles added to it are not
    /// added to the table of copies and slices. O(styles).
    void separateStyles();

    /// A part of these objects; shares whole blocks and the styles. slice(0, 0) has no objects but
    /// the same style table, so that objects added to it can be spliced in without looking up their
    /// styles again.
    Objects slice(std::size_t first, std::size_t count) const;
    /// Replaces objects at several places, which ascend, do not overlap, and are in the old
    /// numbering. `added` holds all new objects, in that order. Returns the removed objects in the
    /// same way.
    Objects splice(std::span<const Splice> splices, const Objects& added);
    Objects splice(std::size_t first, std::size_t removed, const Objects& added);

    std::span<const Shared<ObjectBlock>> blocks() const { return blocks_; }
    std::size_t firstOf(std::size_t block) const { return first_[block]; }
    std::size_t blockOf(std::size_t object) const; ///< the block that contains it
    /// Calls visit(i, ObjectView) for each of `count` objects from `first` on.
    template <class Visit>
    void forEach(std::size_t first, std::size_t count, const Visit& visit) const;
    /// The heap bytes that these objects keep alive and `other` does not, without styles.
    std::size_t bytesNotIn(const Objects& other) const;
    /// Compares the objects, regardless of their division into blocks and of style indices.
    friend bool operator==(const Objects& a, const Objects& b);

private:
    struct Collected;
    ObjectBlock& lastFor(std::uint32_t points);
    void withStylesOf(const Objects& others);

    std::shared_ptr<StyleTable> styles_; // null: no styles yet
    std::vector<Shared<ObjectBlock>> blocks_;
    std::vector<std::uint32_t> first_; // number of the first object of each block
};

template <class Visit>
void Objects::forEach(std::size_t first, std::size_t count, const Visit& visit) const
{
    const std::size_t end = first + count;
    for (std::size_t block = first < end ? blockOf(first) : 0, i = first; i < end; ++block)
        for (const std::size_t last = std::min(end, first_[block] + blocks_[block]->size());
             i < last; ++i)
            visit(i, ObjectView(*blocks_[block], i - first_[block], styles()));
}

} // namespace app
