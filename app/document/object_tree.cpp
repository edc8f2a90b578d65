// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/object_tree.h"

#include <algorithm>

namespace app {

/// Visits the direct children of a container from above: `object(first, end)` for runs of objects,
/// `container(id)` for containers.
template <class OnObjects, class OnContainer>
static void forEachChild(const Containers& containers, ContainerId id, const OnObjects& objects,
                         const OnContainer& container)
{
    const ObjectRange all = id == 0 ? ObjectRange{0, containers.objects()} : containers.rangeOf(id);
    std::size_t end = all.end;
    const std::vector<ContainerId> children = containers.childrenOf(id);
    for (auto child = children.rbegin(); child != children.rend(); ++child) {
        const ObjectRange range = containers.rangeOf(*child);
        if (range.end < end)
            objects(range.end, end);
        container(*child);
        end = range.first;
    }
    if (all.first < end)
        objects(all.first, end);
}

std::vector<TreeRow> ObjectTree::rows(const Containers& containers) const
{
    std::vector<TreeRow> rows;
    append(rows, containers, 0, 1);
    return rows;
}

void ObjectTree::append(std::vector<TreeRow>& rows, const Containers& containers, ContainerId id,
                        int depth) const
{
    using Kind = TreeRow::Kind;
    const bool open = isOpen(id);
    std::size_t room = open ? most(id) : 0, left = 0;
    const auto addObjects = [&](std::size_t first, std::size_t end) {
        const std::size_t count = open ? std::min(room, end - first) : 0;
        for (std::size_t i = 0; i < count; ++i)
            rows.push_back({Kind::Object, id, end - 1 - i, depth});
        room -= count;
        left += end - first - count;
    };
    forEachChild(containers, id, addObjects, [&](ContainerId child) {
        if (containers[child].kind == Container::Kind::Layer) {
            rows.push_back({Kind::Layer, child, 0, depth});
            return append(rows, containers, child, depth + 1);
        }
        if (room == 0) {
            ++left;
            return;
        }
        --room;
        rows.push_back({Kind::Group, child, 0, depth});
        if (isOpen(child))
            append(rows, containers, child, depth + 1);
    });
    if (open && left > 0)
        rows.push_back({Kind::More, id, left, depth});
}

std::size_t ObjectTree::most(ContainerId id) const
{
    const auto found = most_.find(id);
    return found == most_.end() ? atFirst : found->second;
}

void ObjectTree::setOpen(ContainerId id, bool open)
{
    opened_.erase(id); // it is the person's choice now
    if (open)
        open_.insert(id);
    else
        open_.erase(id);
}

void ObjectTree::showMore(ContainerId id) { most_[id] = most(id) + atFirst; }

void ObjectTree::conceal()
{
    for (const ContainerId id : opened_)
        open_.erase(id);
    opened_.clear();
}

void ObjectTree::openAround(const Containers& containers, ContainerId id)
{
    for (; id != 0; id = containers.parentOf(id))
        if (open_.insert(id).second)
            opened_.insert(id);
}

void ObjectTree::revealObject(const Containers& containers, std::size_t object)
{
    conceal();
    ContainerId id = containers.containerOf(object);
    openAround(containers, id);
    for (; id != 0; id = containers.parentOf(id))
        showUpTo(containers, id, object);
}

void ObjectTree::revealGroup(const Containers& containers, ContainerId group)
{
    conceal();
    const ObjectRange range = containers.rangeOf(group);
    ContainerId id = containers.parentOf(group);
    openAround(containers, id);
    for (; id != 0; id = containers.parentOf(id))
        showUpTo(containers, id, range.first);
}

/// Until the child that is, or contains, the object has a row.
void ObjectTree::showUpTo(const Containers& containers, ContainerId id, std::size_t object)
{
    std::size_t before = 0;
    bool found = false;
    forEachChild(
        containers, id,
        [&](std::size_t first, std::size_t end) {
            if (found)
                return;
            found = first <= object && object < end;
            before += found ? end - 1 - object : end - first;
        },
        [&](ContainerId child) {
            if (found)
                return;
            const ObjectRange range = containers.rangeOf(child);
            found = range.first <= object && object < range.end;
            if (!found && containers[child].kind == Container::Kind::Group)
                ++before;
        });
    while (most(id) <= before)
        showMore(id);
}

void ObjectTree::forgetGone(const Containers& containers)
{
    const auto isGone = [&](ContainerId id) { return !containers.contains(id); };
    std::erase_if(open_, isGone);
    std::erase_if(opened_, isGone);
    std::erase_if(most_, [&](const auto& entry) { return isGone(entry.first); });
}

} // namespace app
