// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/object_tree.h"

#include <algorithm>
#include <utility>

namespace app {

namespace {

/// The layers directly in each container, from above. Goes through the containers by their ids:
/// there may be 100,000 groups.
std::map<ContainerId, std::vector<ContainerId>> layersIn(const Containers& containers)
{
    std::map<ContainerId, std::vector<ContainerId>> layers;
    for (ContainerId id = 1; id < containers.nextId(); ++id)
        if (containers.contains(id) && containers[id].kind == Container::Kind::Layer)
            layers[containers.parentOf(id)].push_back(id);
    for (auto& [around, inner] : layers)
        std::ranges::sort(
            inner, [&](ContainerId a, ContainerId b) { return containers.endsBefore(b, a); });
    return layers;
}

/// The child of `id` that contains the object, or `id` if it lies directly in it.
ContainerId childAround(const Containers& containers, ContainerId id, std::size_t object)
{
    ContainerId child = containers.containerOf(object);
    while (child != id && containers.parentOf(child) != id)
        child = containers.parentOf(child);
    return child;
}

} // namespace

struct ObjectTree::Growing {
    const Containers& containers;
    std::map<ContainerId, std::vector<ContainerId>> layers;
    std::vector<TreeRow> rows{};
};

std::vector<TreeRow> ObjectTree::rows(const Containers& containers) const
{
    Growing growing{containers, layersIn(containers)};
    append(growing, 0, 1);
    return std::move(growing.rows);
}

/// Looks only at the children that get a row.
void ObjectTree::append(Growing& growing, ContainerId id, int depth) const
{
    using Kind = TreeRow::Kind;
    const Containers& containers = growing.containers;
    const ObjectRange all = id == 0 ? ObjectRange{0, containers.objects()} : containers.rangeOf(id);
    const std::vector<ContainerId> layers = growing.layers[id];
    auto layer = layers.begin();
    std::size_t end = all.end, room = isOpen(id) ? most(id) : 0;
    const auto appendLayer = [&] {
        end = std::min(end, containers.rangeOf(*layer).first);
        growing.rows.push_back({Kind::Layer, *layer, 0, depth});
        append(growing, *layer++, depth + 1);
    };
    while (end > all.first && room > 0) {
        if (layer != layers.end() && containers.rangeOf(*layer).end >= end) {
            appendLayer();
            continue;
        }
        --room;
        const ContainerId child = childAround(containers, id, end - 1);
        if (child == id) {
            growing.rows.push_back({Kind::Object, id, --end, depth});
            continue;
        }
        growing.rows.push_back({Kind::Group, child, 0, depth});
        if (isOpen(child))
            append(growing, child, depth + 1);
        end = containers.rangeOf(child).first;
    }
    std::size_t left = end - all.first;
    for (; layer != layers.end(); appendLayer())
        left -= containers.rangeOf(*layer).size();
    if (isOpen(id) && left > 0)
        growing.rows.push_back({Kind::More, id, left, depth});
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
/// at the children that have rows.
bool ObjectTree::shows(const Containers& containers, ContainerId id, std::size_t object) const
{
    std::size_t end = containers.rangeOf(id).end;
    for (std::size_t before = 0; before < most(id);) {
        const ContainerId child = childAround(containers, id, end - 1);
        const bool isLayer = child != id && containers[child].kind == Container::Kind::Layer;
        end = child == id ? end - 1 : containers.rangeOf(child).first;
        if (object >= end)
            return true;
        before += !isLayer;
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
