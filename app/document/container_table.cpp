// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/container_table.h"

#include "app/base/memory.h"
#include "app/base/shared.h"

#include <algorithm>
#include <utility>

namespace app {

// 16 bytes for the reference counts of std::make_shared.
static std::size_t heapBytesOf(const Container& container)
{
    return heapBlock(sizeof container + 16) + heapBytes(container.name) + heapBytes(container.svgId)
           + heapBytes(container.title) + heapBytes(container.description)
           + heapBytes(container.newStyle);
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
    own(id).container = std::make_shared<const Container>(std::move(container));
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
            if (mine && (i >= other.blocks_.size() || (*other.blocks_[i])[k].container != mine))
                sum += heapBytesOf(*mine);
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
