// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/stacking.h"

#include <algorithm>

namespace app {
namespace {

/// A list whose items either overlap the choice or do not: runs are divided into objects where some
/// of their objects do.
struct Steps {
    std::vector<std::pair<TreeItem, bool>> items;

    Steps(const TreeItems& list, const Containers& tree, const Overlaps& overlaps)
    {
        for (const TreeItem& item : list) {
            if (item.chosen)
                items.emplace_back(item, false);
            else if (item.id != 0)
                items.emplace_back(item, overlaps(tree.rangeOf(item.id)));
            else
                addRun(item, overlaps);
        }
    }

private:
    void addRun(const TreeItem& run, const Overlaps& overlaps)
    {
        for (std::size_t i = run.objects.first, from = i; i < run.objects.end; ++i) {
            const bool passes = overlaps({i, i + 1});
            if (passes && from < i)
                items.push_back({{0, {from, i}}, false});
            if (passes)
                items.push_back({{0, {i, i + 1}}, true});
            else if (i + 1 == run.objects.end)
                items.push_back({{0, {from, i + 1}}, false});
            from = passes ? i + 1 : from;
        }
    }
};

/// Each chosen item passes the next one that overlaps, upwards in the order of `steps`.
TreeItems passed(const std::vector<std::pair<TreeItem, bool>>& steps)
{
    std::size_t last = steps.size(); // above it nothing overlaps: items stay
    while (last > 0 && !steps[last - 1].second)
        --last;
    TreeItems list, carried;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const auto& [item, overlaps] = steps[i];
        if (item.chosen && i < last) {
            carried.push_back(item);
            continue;
        }
        list.push_back(item);
        if (overlaps)
            list.insert(list.end(), carried.begin(), carried.end());
        if (overlaps)
            carried.clear();
    }
    return list;
}

TreeItems stacked(const TreeItems& list, Stacking how, const Containers& tree,
                  const Overlaps& overlaps)
{
    TreeItems result = list;
    if (how == Stacking::ToFront || how == Stacking::ToBack) {
        std::ranges::stable_partition(result, [how](const TreeItem& item) {
            return item.chosen == (how == Stacking::ToBack);
        });
        return result;
    }
    Steps steps(list, tree, overlaps);
    if (how == Stacking::Raise)
        return passed(steps.items);
    std::ranges::reverse(steps.items);
    result = passed(steps.items);
    std::ranges::reverse(result);
    return result;
}

} // namespace

std::optional<Rearranged> stacked(const Document& document, const ObjectRanges& objects,
                                  ContainerId entered, Stacking how, const Overlaps& overlaps)
{
    TreeDraft draft(document, objects, entered);
    draft.forEachList([&](ContainerId, TreeItems& list) {
        if (std::ranges::any_of(list, &TreeItem::chosen))
            list = stacked(list, how, document.containers(), overlaps);
    });
    return draft.rearranged();
}

std::optional<Rearranged> movedTo(const Document& document, const ObjectRanges& objects,
                                  ContainerId entered, ContainerId layer)
{
    TreeDraft draft(document, objects, entered);
    TreeItems members = draft.chosen();
    draft.forEachList([](ContainerId, TreeItems& list) { std::erase_if(list, &TreeItem::chosen); });
    TreeItems& list = draft.in(layer);
    list.insert(list.end(), members.begin(), members.end());
    return draft.rearranged();
}

std::optional<Rearranged> movedBetween(const Document& document, const ObjectRanges& objects,
                                       ContainerId entered, ContainerId into, std::size_t at)
{
    const Containers& tree = document.containers();
    TreeDraft draft(document, objects, entered);
    const TreeItems members = draft.chosen();
    for (ContainerId around = into; around != 0; around = tree.parentOf(around))
        if (std::ranges::find(members, around, &TreeItem::id) != members.end())
            return Rearranged{};
    TreeItems list;
    std::size_t place = 0;
    for (const TreeItem& item : draft.in(into)) {
        const ObjectRange range = item.id == 0 ? item.objects : tree.rangeOf(item.id);
        if (item.chosen)
            continue;
        if (item.id == 0 && range.first < at && at < range.end) {
            list.push_back({0, {range.first, at}});
            place = list.size();
            list.push_back({0, {at, range.end}});
            continue;
        }
        list.push_back(item);
        if (range.end <= at)
            place = list.size();
    }
    draft.forEachList([](ContainerId, TreeItems& each) { std::erase_if(each, &TreeItem::chosen); });
    list.insert(list.begin() + std::ptrdiff_t(place), members.begin(), members.end());
    draft.in(into) = std::move(list);
    return draft.rearranged();
}

MoveFault faultOf(const Containers& tree, ContainerId id, const ContainerPlace& place)
{
    const auto isGroup = [&](ContainerId of) {
        return of != 0 && tree[of].kind == Container::Kind::Group;
    };
    if (!tree.contains(id) || (place.parent != 0 && !tree.contains(place.parent)))
        return MoveFault::Removed;
    for (ContainerId around = place.parent; around != 0; around = tree.parentOf(around))
        if (around == id)
            return MoveFault::IntoItself;
    if (isGroup(id))
        return place.parent == 0 ? MoveFault::GroupOutOfLayer : MoveFault::None;
    return isGroup(place.parent) ? MoveFault::LayerIntoGroup : MoveFault::None;
}

std::optional<Rearranged> movedContainer(const Document& document, ContainerId id,
                                         const ContainerPlace& place, const ObjectRanges& objects)
{
    const Containers& tree = document.containers();
    if (faultOf(tree, id, place) != MoveFault::None)
        return std::nullopt;
    TreeDraft draft(document, objects);
    std::erase_if(draft.in(tree.parentOf(id)), [&](const TreeItem& item) { return item.id == id; });
    TreeItems& list = draft.in(place.parent);
    auto at = place.below ? list.begin() : list.end();
    if (place.below.value_or(0) != 0)
        if (const auto below = std::ranges::find(list, *place.below, &TreeItem::id);
            below != list.end())
            at = below + 1;
    list.insert(at, TreeItem{id});
    return draft.rearranged();
}

} // namespace app
