// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/container_table.h"

#include <algorithm>
#include <utility>

namespace app {

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
        blocks_.emplace_back(std::vector<Entry>(size));
    own(end_).parent = parent;
    setContainer(std::move(container));
    return end_++;
}

void ContainerTable::startIdsAt(ContainerId id)
{
    static const Shared<std::vector<Entry>> none{std::vector<Entry>(size)};
    end_ = std::max(end_, id);
    blocks_.resize(std::max(blocks_.size(), (end_ + size - 1) / size), none);
}

} // namespace app
