// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/container_marks.h"

#include "app/base/memory.h"
#include "app/base/shared.h"

#include <algorithm>
#include <bit>
#include <iterator>

namespace app {
namespace {

std::uint32_t objectsOf(std::span<const ContainerMark> marks)
{
    std::uint32_t objects = 0;
    for (const ContainerMark& mark : marks)
        objects += mark.objects;
    return objects;
}

auto in(auto& list, std::size_t i) { return list.begin() + std::ptrdiff_t(i); }

} // namespace

ContainerMarks::At ContainerMarks::next(const At& at) const
{
    return at.index + 1 < blocks_[at.block]->size() ? At{at.block, at.index + 1}
                                                    : At{at.block + 1, 0};
}

ContainerMarks::At ContainerMarks::previous(const At& at) const
{
    return at.index > 0 ? At{at.block, at.index - 1}
                        : At{at.block - 1, blocks_[at.block - 1]->size() - 1};
}

const ContainerMark& ContainerMarks::operator[](const At& at) const
{
    ++steps;
    return (*blocks_[at.block])[at.index];
}

std::size_t ContainerMarks::objectsBefore(const At& at) const
{
    if (at == end())
        return objects_;
    steps += at.index + 1;
    return before_[at.block] + objectsOf(std::span(*blocks_[at.block]).first(at.index));
}

ContainerMarks::At ContainerMarks::before(std::size_t object) const
{
    const auto above = std::ranges::upper_bound(before_, object);
    At at{std::size_t(above - before_.begin()) - 1, 0};
    const Block& marks = *blocks_[at.block];
    for (std::size_t end = before_[at.block] + marks[0].objects; end <= object;
         end += marks[at.index].objects)
        ++at.index;
    steps += at.index + std::size_t(std::bit_width(blocks_.size()));
    return at;
}

void ContainerMarks::replace(const At& from, const At& to, std::span<const ContainerMark> marks)
{
    std::size_t first = from.block, last = to.index > 0 ? to.block + 1 : to.block;
    Block all;
    if (from.index > 0)
        all.assign(blocks_[first]->begin(), in(*blocks_[first], from.index));
    all.insert(all.end(), marks.begin(), marks.end());
    if (to.index > 0)
        all.insert(all.end(), in(*blocks_[to.block], to.index), blocks_[to.block]->end());
    if (all.size() < mostInBlock / 2 && last < blocks_.size()) { // too few for a block
        all.insert(all.end(), blocks_[last]->begin(), blocks_[last]->end());
        ++last;
    } else if (all.size() < mostInBlock / 2 && first > 0) {
        --first;
        all.insert(all.begin(), blocks_[first]->begin(), blocks_[first]->end());
    }

    const std::size_t count = (all.size() + mostInBlock - 1) / mostInBlock;
    std::vector<Shared<Block>> blocks;
    for (std::size_t i = 0; i < count; ++i)
        blocks.emplace_back(
            Block(in(all, all.size() * i / count), in(all, all.size() * (i + 1) / count)));
    exchangeBlocks(first, last, std::move(blocks));
    steps += all.size() + blocks_.size();
}

std::size_t ContainerMarks::bytesNotIn(const ContainerMarks& other) const
{
    std::size_t sum = heapBytes(blocks_) + heapBytes(before_);
    forEachNotIn(other.blocks_, blocks_, [&](std::size_t i) {
        sum += heapBlock(Shared<Block>::allocated()) + heapBytes(*blocks_[i]);
    });
    return sum;
}

void ContainerMarks::exchangeBlocks(std::size_t first, std::size_t last,
                                    std::vector<Shared<Block>> blocks)
{
    std::size_t objects = first < blocks_.size() ? before_[first] : objects_;
    const std::size_t then = last < blocks_.size() ? before_[last] : objects_;
    std::vector<std::uint32_t> before;
    for (const Shared<Block>& block : blocks) {
        before.push_back(std::uint32_t(objects));
        objects += objectsOf(*block);
    }
    const auto shift = std::uint32_t(objects - then); // modulo 2^32
    std::for_each(in(before_, last), before_.end(), [&](std::uint32_t& n) { n += shift; });
    objects_ += objects - then;
    before_.erase(in(before_, first), in(before_, last));
    before_.insert(in(before_, first), before.begin(), before.end());
    blocks_.erase(in(blocks_, first), in(blocks_, last));
    blocks_.insert(in(blocks_, first), std::make_move_iterator(blocks.begin()),
                   std::make_move_iterator(blocks.end()));
}

} // namespace app
