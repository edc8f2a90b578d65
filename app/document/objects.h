// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_view.h"
#include "app/document/splice.h"

#include <memory>

namespace app {

/// Any number of objects (fewer than 2^32) in painting order: blocks that are shared between
/// documents, snapshots and the history. Copying one costs a list of 12 bytes a block, reading an
/// object O(log blocks); a splice copies the blocks it touches. Copies and slices also share the
/// table of styles, which only grows.
class Objects {
public:
    std::size_t size() const
    {
        return blocks_.empty() ? 0 : first_.back() + blocks_.back()->size();
    }
    bool empty() const { return blocks_.empty(); }
    ObjectView operator[](std::size_t i) const;

    void append(const Object& object);
    void append(const ObjectRow& row); ///< the row's style is one of `styles()`
    void appendLine(const clipping::Segment& line, StyleIndex style); ///< without an Object between
    void append(const Objects& more);                                 ///< shares whole blocks
    StyleTable& styles();
    const StyleTable& styles() const;
    /// Gives these a table of their own, with the same numbers: styles that are added to it are not
    /// added to that of copies and slices. O(styles).
    void separateStyles();

    /// Some of them, which share whole blocks and the styles. slice(0, 0): none yet, but the
    /// styles, so that what is collected there is spliced in without looking its styles up again.
    Objects slice(std::size_t first, std::size_t count) const;
    /// Exchanges objects in places that are ascending, do not overlap, and are numbered as before.
    /// `added` are all that come, one after the other. Returns those that went, likewise.
    Objects splice(std::span<const Splice> splices, const Objects& added);
    Objects splice(std::size_t first, std::size_t removed, const Objects& added);

    std::span<const Shared<ObjectBlock>> blocks() const { return blocks_; }
    std::size_t firstOf(std::size_t block) const { return first_[block]; }
    std::size_t blockOf(std::size_t object) const; ///< the block that it is in
    /// Calls visit(i, ObjectView) for each of `count` objects from `first` on.
    template <class Visit>
    void forEach(std::size_t first, std::size_t count, const Visit& visit) const;
    /// Bytes of the heap that it keeps alive and `other` does not, without the styles.
    std::size_t bytesNotIn(const Objects& other) const;
    /// The same objects, however they lie in blocks and whatever their styles' numbers are.
    friend bool operator==(const Objects& a, const Objects& b);

private:
    struct Collected;
    ObjectBlock& lastFor(std::uint32_t points);
    void withStylesOf(const Objects& others);

    std::shared_ptr<StyleTable> styles_; // null: none yet
    std::vector<Shared<ObjectBlock>> blocks_;
    std::vector<std::uint32_t> first_; // of each block
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
