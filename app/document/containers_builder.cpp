// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/containers_builder.h"

#include <cassert>
#include <utility>

namespace app {

ContainersBuilder::ContainersBuilder() : marks_{{0, 0, 0}}, open_{0} {}

bool ContainersBuilder::canOpen() const
{
    return count_ < Containers::mostContainers && depth() < Containers::deepest;
}

ContainerId ContainersBuilder::open(Container container)
{
    assert(canOpen());
    assert(table_.mayHold(open_.back(), container.kind));
    const ContainerId id = table_.add(std::move(container), open_.back());
    marks_.push_back({id, 0, 0});
    open_.push_back(id);
    ++count_;
    return id;
}

void ContainersBuilder::addObjects(std::size_t count)
{
    assert(depth() > 0);
    marks_.back().objects += std::uint32_t(count);
}

void ContainersBuilder::close()
{
    assert(depth() > 0);
    marks_.push_back({open_.back(), 1, 0});
    open_.pop_back();
}

Containers ContainersBuilder::take()
{
    assert(depth() == 0);
    if (count_ == 0) {
        open({.name = QStringLiteral("Drawing")});
        close();
    }
    marks_.push_back({0, 1, 0});
    return Containers(ContainerMarks(marks_), std::move(table_), count_);
}

} // namespace app
