// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/object_tree.h"

#include <algorithm>
#include <utility>

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

bool ObjectTree::conceal()
{
    for (const ContainerId id : opened_)
        open_.erase(id);
    return !std::exchange(opened_, {}).empty();
}

bool ObjectTree::revealObject(const Containers& containers, std::size_t object)
{
    return reveal(containers, containers.containerOf(object), object);
}

bool ObjectTree::revealGroup(const Containers& containers, ContainerId group)
{
    return reveal(containers, containers.parentOf(group), containers.rangeOf(group).first);
}

bool ObjectTree::reveal(const Containers& containers, ContainerId around, std::size_t object)
{
    const auto before = open_;
    conceal();
    std::vector<ContainerId> inward;
    for (ContainerId id = around; id != 0; id = containers.parentOf(id))
        inward.insert(inward.begin(), id);
    for (const ContainerId id : inward) {
        if (!shows(containers, id, object))
            break;
        if (open_.insert(id).second)
            opened_.insert(id);
    }
    return open_ != before;
}

/// Whether it has a row for the child that is, or contains, the object while it is open. Looks only
/// at the children that have rows: there may be 100,000.
bool ObjectTree::shows(const Containers& containers, ContainerId id, std::size_t object) const
{
    std::size_t end = containers.rangeOf(id).end;
    for (std::size_t before = 0; before < most(id);) {
        if (object == end - 1)
            return true;
        ContainerId child = containers.containerOf(end - 1);
        if (child == id) { // the object lies directly in it
            --end;
            ++before;
            continue;
        }
        while (containers.parentOf(child) != id)
            child = containers.parentOf(child);
        end = containers.rangeOf(child).first;
        if (object >= end)
            return true;
        before += containers[child].kind == Container::Kind::Group;
    }
    return false;
}

void ObjectTree::forgetGone(const Containers& containers)
{
    const auto isGone = [&](ContainerId id) { return !containers.contains(id); };
    std::erase_if(open_, isGone);
    std::erase_if(opened_, isGone);
    std::erase_if(most_, [&](const auto& entry) { return isGone(entry.first); });
}

} // namespace app
