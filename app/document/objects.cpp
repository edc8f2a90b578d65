// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/objects.h"

#include <algorithm>
#include <cassert>
#include <map>

namespace app {
namespace {

// Whether adjacent blocks of these weights become one block: one of them is small and both fit.
bool join(std::uint32_t a, std::uint32_t b)
{
    return (a < ObjectBlock::fewPoints || b < ObjectBlock::fewPoints)
           && a + b <= ObjectBlock::mostPoints;
}

// Some objects of an existing block.
struct Piece {
    const Shared<ObjectBlock>* block;
    std::size_t first, count;
};

} // namespace

/// Builds Objects from pieces of blocks. A whole block that is not merged with others is shared.
/// Invariant: of two adjacent blocks, both have at least `fewPoints`, or the two do not fit into
/// one. If the source blocks satisfy this, only the blocks next to a cut are copied.
struct Objects::Collected {
    explicit Collected(std::shared_ptr<StyleTable> styles) { objects.styles_ = std::move(styles); }

    void add(const Objects& from, std::size_t first, std::size_t end)
    {
        for (std::size_t block = first < end ? from.blockOf(first) : 0; first < end; ++block) {
            const Shared<ObjectBlock>& source = from.blocks_[block];
            const std::size_t at = first - from.first_[block];
            const std::size_t count = std::min(end - first, source->size() - at);
            add(Piece{&source, at, count});
            first += count;
        }
    }

    Objects take()
    {
        endBlock();
        return std::move(objects);
    }

private:
    void add(const Piece& piece)
    {
        const std::uint32_t more = (*piece.block)->pointsOf(piece.first, piece.count);
        if (!pieces.empty() && !join(points, more))
            endBlock();
        pieces.push_back(piece);
        points += more;
    }

    void endBlock()
    {
        if (pieces.empty())
            return;
        objects.first_.push_back(std::uint32_t(objects.size()));
        if (pieces.size() == 1 && pieces[0].count == (*pieces[0].block)->size())
            objects.blocks_.push_back(*pieces[0].block);
        else
            objects.blocks_.emplace_back(joined());
        pieces.clear();
        points = 0;
    }

    ObjectBlock joined() const
    {
        ObjectBlock block;
        std::size_t size = 0;
        for (const Piece& piece : pieces)
            size += piece.count;
        if ((*pieces[0].block)->paths.empty())
            block.lines.reserve(size);
        else
            block.paths.reserve(size);
        for (const Piece& piece : pieces)
            block.append(**piece.block, piece.first, piece.count);
        block.narrow();
        return block;
    }

    Objects objects;
    std::vector<Piece> pieces; // of the block being built
    std::uint32_t points = 0;  // the sum of their weights
};

std::size_t Objects::blockOf(std::size_t object) const
{
    assert(object < size());
    return std::size_t(std::ranges::upper_bound(first_, object) - first_.begin()) - 1;
}

ObjectView Objects::operator[](std::size_t i) const
{
    const std::size_t block = blockOf(i);
    return {*blocks_[block], i - first_[block], styles()};
}

StyleTable& Objects::styles()
{
    if (!styles_)
        styles_ = std::make_shared<StyleTable>();
    return *styles_;
}

const StyleTable& Objects::styles() const
{
    static const StyleTable none;
    return styles_ ? *styles_ : none;
}

// The last block, for writing, with room for `points` more points.
ObjectBlock& Objects::lastFor(std::uint32_t points)
{
    if (blocks_.empty() || blocks_.back()->points + points > ObjectBlock::mostPoints) {
        if (!blocks_.empty() && !blocks_.back().isShared())
            blocks_.back().own().narrow(); // it is full: free its reserved memory
        first_.push_back(std::uint32_t(size()));
        blocks_.emplace_back();
    }
    return blocks_.back().own();
}

void Objects::separateStyles()
{
    if (styles_)
        styles_ = std::make_shared<StyleTable>(*styles_);
}

void Objects::append(const Object& object)
{
    append({object.path, styles().entryOf(object.style), object.hidden,
            object.particulars == Particulars{} ? noParticulars() : Shared(object.particulars)});
}

void Objects::append(const ObjectRow& row)
{
    const StyleIndex style = styles().indexOf(row.style);
    lastFor(weight(row.path)).append(row, style);
}

void Objects::appendLine(const clipping::Segment& line, const StyleEntry& style)
{
    const StyleIndex index = styles().indexOf(style);
    lastFor(2).append(line, index);
}

void Objects::append(const Objects& more) { splice(size(), 0, more); }

Objects Objects::slice(std::size_t first, std::size_t count) const
{
    assert(first + count <= size());
    Collected some(styles_);
    some.add(*this, first, first + count);
    return some.take();
}

Objects Objects::splice(std::span<const Splice> splices, const Objects& added)
{
    Objects coming = added;
    coming.withStylesOf(*this);
    Collected staying(coming.styles_), going(coming.styles_);
    std::size_t at = 0, from = 0;
    for (const Splice& s : splices) {
        const std::size_t end = std::size_t(s.first) + s.removed;
        assert(s.first >= at && end <= size());
        staying.add(*this, at, s.first);
        going.add(*this, s.first, end);
        staying.add(coming, from, from + s.added);
        at = end;
        from += s.added;
    }
    assert(from == added.size());
    staying.add(*this, at, size());
    Objects gone = going.take(); // while the source blocks still exist
    *this = staying.take();
    return gone;
}

Objects Objects::splice(std::size_t first, std::size_t removed, const Objects& added)
{
    const Splice one{std::uint32_t(first), std::uint32_t(removed), std::uint32_t(added.size())};
    return splice({&one, 1}, added);
}

// Renumbers the styles by the table of `others`, which this object then shares.
void Objects::withStylesOf(const Objects& others)
{
    if (!others.styles_ || styles_ == others.styles_)
        return;
    std::map<StyleIndex, StyleIndex> numbers;
    const auto numberOf = [&](StyleIndex old) {
        const auto [at, isNew] = numbers.try_emplace(old);
        if (isNew)
            at->second = others.styles_->indexOf((*styles_)[old]);
        return at->second;
    };
    for (Shared<ObjectBlock>& block : blocks_) {
        std::vector<StyleIndex> styles(block->styles.size());
        std::ranges::transform(block->styles, styles.begin(), numberOf);
        if (styles != block->styles)
            block.own().styles = std::move(styles);
    }
    styles_ = others.styles_;
}

} // namespace app
