// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/new_groups.h"

namespace app {

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
