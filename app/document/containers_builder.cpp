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

std::optional<Containers> withGroups(const Containers& tree, std::span<const NewGroup> groups)
{
    if (groups.empty())
        return tree;
    if (tree.size() + groups.size() > Containers::mostContainers)
        return std::nullopt;
    Containers::Parts parts = tree.parts();
    std::vector<ContainerMark> marks;
    marks.reserve(parts.marks.size() + 2 * groups.size());
    std::size_t object = 0; // the first that is not yet below a mark
    for (const ContainerMark& mark : parts.marks) {
        marks.push_back(mark);
        const std::size_t end = object + mark.objects;
        const auto cover = [&](std::size_t to) {
            marks.back().objects = std::uint32_t(to - object);
            object = to;
        };
        for (; !groups.empty() && groups.front().objects.end <= end; groups = groups.subspan(1)) {
            const ContainerId id = parts.nextId++;
            parts.containers.push_back(groups.front().group);
            parts.containers.back().id = id;
            parts.containers.back().kind = Container::Kind::Group;
            cover(groups.front().objects.first);
            marks.push_back({id, 0, 0});
            cover(groups.front().objects.end);
            marks.push_back({id, 1, 0});
        }
        cover(end);
    }
    parts.marks = std::move(marks);
    return Containers::of(parts);
}

} // namespace app
