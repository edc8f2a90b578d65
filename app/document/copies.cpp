// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/copies.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <unordered_map>

namespace app {
namespace {

Objects withoutIds(const Objects& objects)
{
    Objects result = objects.slice(0, 0);
    objects.forEach(0, objects.size(), [&](std::size_t, const ObjectView& object) {
        ObjectRow row = object.row();
        if (!row.particulars->id.isEmpty())
            row.particulars.own().id.clear();
        result.append(row);
    });
    return result;
}

/// Takes a drawing apart, and puts its parts into a draft of another one.
class Inserting {
public:
    Inserting(TreeDraft& draft, const Document& other)
        : draft_(draft), from_(other), tree_(other.containers()),
          objects_(draft.adding(withoutIds(other.objects())).objects)
    {
    }
    void into(TreeItems& list, ContainerId of = 0)
    {
        for (const TreeItem& item : TreeItems(from_.in(of))) {
            if (item.id == 0) {
                const ObjectRange& range = item.objects;
                list.push_back(
                    {0, {objects_.first + range.first, objects_.first + range.end}, true});
            } else if (from_[item.id].kind == Container::Kind::Layer) {
                if (from_[item.id].underlay)
                    list.push_back({draft_.make(imageLayer(item.id))});
                into(list, item.id);
            } else {
                Container container = from_[item.id];
                container.svgId.clear();
                const ContainerId group = draft_.make(std::move(container));
                list.push_back({group});
                TreeItems members;
                into(members, item.id);
                draft_.in(group) = std::move(members);
            }
        }
    }

private:
    Container imageLayer(ContainerId layer) const
    {
        Underlay image = *tree_[layer].underlay;
        image.svgId.clear();
        return {.name = tree_[layer].name,
                .visible = tree_.shown(layer),
                .locked = true,
                .underlay = std::move(image)};
    }

    TreeDraft& draft_;
    TreeDraft from_;
    const Containers tree_;
    ObjectRange objects_;
};

std::size_t layerCount(const Containers& tree)
{
    return std::size_t(std::ranges::count_if(
        tree.inOrder(), [&](ContainerId id) { return tree[id].kind == Container::Kind::Layer; }));
}

/// Puts layers below all groups around a group, as a group holds no layer.
void putBelowGroups(TreeDraft& draft, const Containers& tree, ContainerId group,
                    const TreeItems& layers)
{
    while (tree[tree.parentOf(group)].kind == Container::Kind::Group)
        group = tree.parentOf(group);
    TreeItems& list = draft.in(tree.parentOf(group));
    list.insert(std::ranges::find(list, group, &TreeItem::id), layers.begin(), layers.end());
}

} // namespace

std::optional<Rearranged> withCopies(const Document& document, const ObjectRanges& objects,
                                     ContainerId entered, std::span<const RowChange> changes)
{
    TreeDraft draft(document, objects, entered);
    draft.forEachList([&](ContainerId, TreeItems& list) {
        const TreeItems originals = list;
        for (const RowChange& change : changes)
            for (const TreeItem& item : originals)
                if (item.chosen)
                    list.push_back(draft.copied(item, change));
    });
    return draft.rearranged();
}

std::optional<Rearranged> withDrawing(const Document& document, const Document& other,
                                      ContainerId into)
{
    TreeDraft draft(document);
    TreeItems more;
    Inserting(draft, other).into(more);
    const Containers& tree = document.containers();
    if (const std::size_t images = other.containers().underlaid().size();
        images > 0 && layerCount(tree) + images > Containers::mostLayers)
        return std::nullopt;
    if (tree[into].kind == Container::Kind::Group) {
        const auto isLayer = [&](const TreeItem& item) {
            return item.id != 0 && draft[item.id].kind == Container::Kind::Layer;
        };
        TreeItems layers;
        std::ranges::copy_if(more, std::back_inserter(layers), isLayer);
        std::erase_if(more, isLayer);
        if (!layers.empty())
            putBelowGroups(draft, tree, into, layers);
    }
    TreeItems& list = draft.in(into);
    list.insert(list.end(), more.begin(), more.end());
    return draft.rearranged();
}

namespace {

constexpr int mostSteps = 1000;

std::optional<Point> startOf(const ObjectView& object)
{
    if (const auto line = object.singleLine())
        return line->a;
    std::optional<Point> start;
    object.path().forEachPoint([&](const Point& p) { start = start ? start : p; });
    return start;
}

std::size_t keyOf(const Point& start)
{
    return std::hash<double>{}(start.x) * 31 + std::hash<double>{}(start.y);
}

/// An index of the drawing's objects by their start points.
class Starts {
public:
    explicit Starts(const Objects& objects) : objects_(objects)
    {
        numbers_.reserve(objects.size());
        objects.forEach(0, objects.size(), [&](std::size_t i, const ObjectView& object) {
            if (const auto start = startOf(object))
                numbers_.emplace(keyOf(*start), std::uint32_t(i));
        });
    }

    bool hold(const ObjectView& object, const Point& offset) const
    {
        const auto start = startOf(object);
        if (!start)
            return false;
        const auto [first, last] = numbers_.equal_range(keyOf(*start + offset));
        if (first == last)
            return false;
        const Path moved = object.path().placed({{1, 1}, offset});
        return std::any_of(
            first, last, [&](const auto& entry) { return objects_[entry.second].path() == moved; });
    }

private:
    const Objects& objects_;
    std::unordered_multimap<std::size_t, std::uint32_t> numbers_;
};

bool anyHeld(const Starts& starts, const Objects& copies, const Point& offset)
{
    for (std::size_t i = 0; i < copies.size(); ++i)
        if (starts.hold(copies[i], offset))
            return true;
    return false;
}

} // namespace

Point copyOffset(const Document& document, const Objects& copies, const Point& step)
{
    const Starts starts(document.objects());
    for (int steps = 1; steps < mostSteps; ++steps)
        if (const Point offset = double(steps) * step; !anyHeld(starts, copies, offset))
            return offset;
    return double(mostSteps) * step;
}

} // namespace app
