// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/copies.h"

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
        : draft_(draft), from_(other), objects_(draft.adding(withoutIds(other.objects())).objects)
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
    TreeDraft& draft_;
    TreeDraft from_;
    ObjectRange objects_;
};

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
    TreeItems& list = draft.in(into);
    list.insert(list.end(), more.begin(), more.end());
    return draft.rearranged();
}

} // namespace app
