// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/container_table.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

/// The tree of containers as one would draw it: each has a list of objects and containers. Nothing
/// in it is fast.
namespace nested {

using app::Container;
using app::ContainerId;

struct Node;
using Item = std::shared_ptr<Node>; ///< null: an object

struct Node {
    Container container;
    std::vector<Item> items{};

    std::size_t objects() const
    {
        std::size_t count = 0;
        for (const Item& item : items)
            count += item ? item->objects() : 1;
        return count;
    }
    bool isGroup() const { return container.kind == Container::Kind::Group; }
};

inline Item copy(const Item& item)
{
    if (!item)
        return item;
    auto made = std::make_shared<Node>(Node{item->container});
    for (const Item& each : item->items)
        made->items.push_back(copy(each));
    return made;
}

/// What is said of a container by where it is.
struct Seen {
    Item node;
    ContainerId parent;
    std::size_t first;
    int depth;
    bool shown, locked;
};

/// Every container below `node`, each before those in it.
inline std::vector<Seen> seen(const Item& node, std::size_t first = 0, int depth = 1,
                              bool shown = true, bool locked = false)
{
    std::vector<Seen> all;
    for (const Item& item : node->items) {
        if (item) {
            const bool nowShown = shown && item->container.visible;
            const bool nowLocked = locked || item->container.locked;
            all.push_back({item, node->container.id, first, depth, nowShown, nowLocked});
            const auto inner = seen(item, first, depth + 1, nowShown, nowLocked);
            all.insert(all.end(), inner.begin(), inner.end());
        }
        first += item ? item->objects() : 1;
    }
    return all;
}

/// The innermost layer that a container is or lies in, of those in `all`.
inline ContainerId layerAround(const std::vector<Seen>& all, Item node)
{
    while (node->isGroup()) {
        const auto at = std::ranges::find(all, node, &Seen::node);
        node = std::ranges::find(all, at->parent, [](const Seen& each) {
                   return each.node->container.id;
               })->node;
    }
    return node->container.id;
}

/// The container around each object, from the bottom up.
inline std::vector<Item> owners(const Item& node)
{
    std::vector<Item> all;
    for (const Item& item : node->items) {
        if (!item) {
            all.push_back(node);
            continue;
        }
        const auto inner = owners(item);
        all.insert(all.end(), inner.begin(), inner.end());
    }
    return all;
}

/// Takes the objects [first, end) away; those in `node` begin at `at`. Groups that this empties are
/// marked by the id 0.
inline void takeAway(const Item& node, std::size_t at, std::size_t first, std::size_t end)
{
    std::vector<Item> left;
    for (const Item& item : node->items) {
        const std::size_t next = at + (item ? item->objects() : 1);
        if (item)
            takeAway(item, at, first, end);
        if (item || at < first || at >= end)
            left.push_back(item);
        at = next;
    }
    node->items = left;
}

/// Puts objects into the container of that id, at the last place there with `first` objects below.
inline bool putIn(const Item& node, std::size_t at, std::size_t first, std::size_t count,
                  ContainerId into)
{
    std::size_t place = node->items.size() + 1;
    for (std::size_t i = 0; i <= node->items.size(); ++i) {
        if (at == first && node->container.id == into)
            place = i;
        if (i == node->items.size())
            break;
        const Item& item = node->items[i];
        if (item && putIn(item, at, first, count, into))
            return true;
        at += item ? item->objects() : 1;
    }
    if (place > node->items.size())
        return false;
    node->items.insert(node->items.begin() + std::ptrdiff_t(place), count, nullptr);
    return true;
}

inline void dropEmptied(const Item& node, const std::vector<ContainerId>& hadObjects)
{
    std::erase_if(node->items, [&](const Item& item) {
        return item && item->isGroup() && item->objects() == 0
               && std::ranges::find(hadObjects, item->container.id) != hadObjects.end();
    });
    for (const Item& item : node->items)
        if (item)
            dropEmptied(item, hadObjects);
}

inline void splice(const Item& root, std::size_t first, std::size_t removed, std::size_t added,
                   ContainerId into)
{
    std::vector<ContainerId> hadObjects;
    for (const Seen& each : seen(root))
        if (each.node->objects() > 0)
            hadObjects.push_back(each.node->container.id);
    takeAway(root, 0, first, first + removed);
    if (added > 0)
        putIn(root, 0, first, added, into);
    dropEmptied(root, hadObjects);
}

} // namespace nested
