// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/regrouping.h"

#include <algorithm>

namespace app {
namespace {

/// The list that holds the topmost chosen item; null if nothing is chosen.
TreeItems* listOfTopmost(TreeDraft& draft, ContainerId id = 0)
{
    TreeItems& list = draft.in(id);
    for (std::size_t i = list.size(); i-- > 0;) {
        if (list[i].chosen)
            return &list;
        if (list[i].id != 0)
            if (TreeItems* found = listOfTopmost(draft, list[i].id))
                return found;
    }
    return nullptr;
}

} // namespace

std::optional<Rearranged> grouped(const Document& document, const ObjectRanges& objects,
                                  ContainerId entered)
{
    TreeDraft draft(document, objects, entered);
    TreeItems members = draft.chosen();
    TreeItems* around = listOfTopmost(draft);
    if (!around)
        return draft.rearranged();
    const ContainerId group = draft.make({.kind = Container::Kind::Group});
    const auto topmost = std::ranges::find_if(around->rbegin(), around->rend(), &TreeItem::chosen);
    *topmost = {group};
    draft.forEachList([](ContainerId, TreeItems& list) { std::erase_if(list, &TreeItem::chosen); });
    draft.in(group) = std::move(members);
    return draft.rearranged();
}

std::optional<Rearranged> ungrouped(const Document& document, const ObjectRanges& objects,
                                    ContainerId entered)
{
    TreeDraft draft(document, objects, entered);
    draft.forEachList([&](ContainerId, TreeItems& list) {
        TreeItems members;
        for (const TreeItem& item : list)
            if (item.chosen && item.id != 0)
                std::ranges::copy(draft.in(item.id), std::back_inserter(members));
            else
                members.push_back(item);
        list = std::move(members);
    });
    return draft.rearranged();
}

} // namespace app
