// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/tree_draft.h"

#include "app/document/hidden_objects.h"
#include "app/document/moved_runs.h"

#include <algorithm>

namespace app {

TreeDraft::TreeDraft(const Document& document, const ObjectRanges& chosen, ContainerId entered)
    : document_(document), chosen_(chosen), firstMade_(document.containers().nextId()),
      added_(document.objects().slice(0, 0))
{
    takeApart(document.containers().parts(), chosen);
    if (!chosen.empty())
        chooseGroups(entered);
}

// Divides each run of objects where the choice begins or ends.
void TreeDraft::takeApart(const Containers::Parts& parts, const ObjectRanges& chosen)
{
    auto next = chosen.ranges().begin();
    const auto none = chosen.ranges().end();
    const auto append = [&](TreeItems& list, std::size_t at, std::size_t end) {
        while (at < end) {
            while (next != none && next->end <= at)
                ++next;
            const bool inside = next != none && next->first <= at;
            const std::size_t edge = next == none ? end : inside ? next->end : next->first;
            const std::size_t to = std::min(end, edge);
            list.push_back({0, {at, to}, false, inside});
            at = to;
        }
    };
    std::vector<ContainerId> open;
    std::size_t object = 0;
    for (const ContainerMark& mark : parts.marks) {
        if (mark.closes) {
            open.pop_back();
        } else {
            if (!open.empty())
                lists_[open.back()].push_back({mark.id});
            open.push_back(mark.id);
        }
        if (mark.objects > 0)
            append(lists_[open.back()], object, object + mark.objects);
        object += mark.objects;
    }
}

void TreeDraft::chooseGroups(ContainerId entered)
{
    const Containers& tree = document_.containers();
    const ObjectRanges others = without(editableObjects(document_), chosen_);
    for (auto& [id, list] : lists_)
        for (TreeItem& item : list) {
            if (item.id == 0 || tree[item.id].kind != Container::Kind::Group)
                continue;
            const ObjectRange range = tree.rangeOf(item.id);
            item.chosen = meets(chosen_, range) && !meets(others, range);
        }
    for (ContainerId id = entered; id != 0 && tree.contains(id); id = tree.parentOf(id))
        for (TreeItem& item : lists_[tree.parentOf(id)])
            if (item.id == id)
                item.chosen = false;
}

const Container& TreeDraft::operator[](ContainerId id) const
{
    return id < firstMade_ ? document_.containers()[id] : made_[id - firstMade_];
}

void TreeDraft::forEachList(const Visit& visit) { this->visit(0, visit); }

void TreeDraft::visit(ContainerId id, const Visit& visit)
{
    for (std::size_t i = 0; i < lists_[id].size(); ++i)
        if (const TreeItem item = lists_[id][i]; item.id != 0 && !item.chosen)
            this->visit(item.id, visit);
    visit(id, lists_[id]);
}

TreeItems TreeDraft::chosen() const
{
    TreeItems all;
    collect(0, all);
    return all;
}

void TreeDraft::collect(ContainerId id, TreeItems& chosen) const
{
    const auto list = lists_.find(id);
    if (list == lists_.end())
        return;
    for (const TreeItem& item : list->second) {
        if (item.chosen)
            chosen.push_back(item);
        else if (item.id != 0)
            collect(item.id, chosen);
    }
}

ContainerId TreeDraft::make(Container container)
{
    container.id = firstMade_ + ContainerId(made_.size());
    made_.push_back(std::move(container));
    return made_.back().id;
}

TreeItem TreeDraft::adding(const Objects& objects)
{
    const std::size_t first = added_.size();
    added_.append(objects);
    return {0, {first, added_.size()}, true};
}

TreeItem TreeDraft::copied(const TreeItem& item, const std::function<void(ObjectRow&)>& change)
{
    if (item.id == 0) {
        const std::size_t first = added_.size();
        document_.objects().forEach(item.objects.first, item.objects.size(),
                                    [&](std::size_t, const ObjectView& object) {
                                        ObjectRow row = object.row();
                                        if (!row.particulars->id.isEmpty())
                                            row.particulars.own().id.clear();
                                        change(row);
                                        added_.append(row);
                                    });
        return {0, {first, added_.size()}, true};
    }
    Container container = (*this)[item.id];
    container.svgId.clear();
    const ContainerId copy = make(std::move(container));
    TreeItems list;
    for (const TreeItem& inner : TreeItems(lists_[item.id]))
        list.push_back(copied(inner, change));
    lists_[copy] = std::move(list);
    return {copy};
}

} // namespace app
