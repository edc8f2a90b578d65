// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/container_table.h"

#include "app/base/memory.h"
#include "app/base/shared.h"

#include <algorithm>
#include <utility>

namespace app {

// 16 bytes for the reference counts of std::make_shared.
// `other`, which may be null, is one whose image file is counted there.
static std::size_t heapBytesOf(const Container& container, const Container* other)
{
    std::size_t ofImage = 0;
    if (const SharedUnderlay& own = container.underlay) {
        ofImage = heapBlock(sizeof(Underlay) + 16) + heapBytes(own->clip) + heapBytes(own->svgId);
        if (!other || !other->underlay || other->underlay->file != own->file)
            ofImage += heapBlock(std::size_t(own->file->bytes.size()));
    }
    return ofImage + heapBlock(sizeof container + 16) + heapBytes(container.name)
           + heapBytes(container.svgId) + heapBytes(container.title)
           + heapBytes(container.description) + heapBytes(container.newStyle);
}

const Shared<ContainerTable::Block>& ContainerTable::unused()
{
    static const Shared<Block> entries{Block(size)};
    return entries;
}

ContainerTable::ContainerTable() { add({}, 0); }

void ContainerTable::setContainer(Container container)
{
    const ContainerId id = container.id;
    const auto& before = (*this)[id].container;
    underlaid_ -= before && before->underlay ? 1 : 0;
    underlaid_ += container.underlay ? 1 : 0;
    own(id).container = std::make_shared<const Container>(std::move(container));
}

void ContainerTable::remove(ContainerId id)
{
    const auto& before = (*this)[id].container;
    underlaid_ -= before && before->underlay ? 1 : 0;
    own(id) = {};
}

ContainerId ContainerTable::add(Container container, ContainerId parent)
{
    container.id = end_;
    if (end_ == blocks_.size() * size)
        blocks_.push_back(unused());
    own(end_).parent = parent;
    setContainer(std::move(container));
    return end_++;
}

// Containers shared by both tables have the same id.
std::size_t ContainerTable::bytesNotIn(const ContainerTable& other) const
{
    std::size_t sum = heapBytes(blocks_);
    forEachNotIn(other.blocks_, blocks_, [&](std::size_t i) {
        if (sameAddress(blocks_[i], unused()))
            return;
        sum += heapBlock(Shared<Block>::allocated()) + heapBytes(*blocks_[i]);
        for (std::size_t k = 0; k < size; ++k) {
            const auto& mine = (*blocks_[i])[k].container;
            const Container* const theirs =
                i < other.blocks_.size() ? (*other.blocks_[i])[k].container.get() : nullptr;
            if (mine && theirs != mine.get())
                sum += heapBytesOf(*mine, theirs);
        }
    });
    return sum;
}

void ContainerTable::startIdsAt(ContainerId id)
{
    end_ = std::max(end_, id);
    blocks_.resize(std::max(blocks_.size(), (end_ + size - 1) / size), unused());
}

} // namespace app
