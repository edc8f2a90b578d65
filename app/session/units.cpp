// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/units.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/document/hidden_objects.h"
#include "app/document/moved_runs.h"
#include "app/document/tree_draft.h"
#include "app/session/node_numbers.h"
#include "app/session/window_words.h"

namespace app {
namespace {

bool isGroup(const Containers& tree, ContainerId id)
{
    return tree[id].kind == Container::Kind::Group;
}

/// Widens the set to whole groups, or takes out those that are not in it as a whole.
class Widening {
public:
    Widening(const Session& session, ObjectRanges found, FoundGroups groups)
        : session_(session), tree_(session.now().containers()),
          editable_(editableObjects(session.now())), found_(std::move(found)), groups_(groups)
    {
    }
    ObjectRanges in(ContainerId id)
    {
        widen(id);
        return united(without(found_, groupObjects_), chosen_);
    }

private:
    void widen(ContainerId id)
    {
        for (const ContainerId child : tree_.childrenOf(id)) {
            const ObjectRange range = tree_.rangeOf(child);
            if (!meets(found_, range))
                continue;
            if (!isGroup(tree_, child) || session_.entered.contains(child))
                widen(child);
            else
                choose(range);
        }
    }
    void choose(const ObjectRange& range)
    {
        const ObjectRanges unit = within(editable_, range);
        groupObjects_.insert(range);
        if (groups_ == FoundGroups::Any || unit.size() == within(found_, range).size())
            for (const ObjectRange& part : unit.ranges())
                chosen_.insert(part);
    }

    const Session& session_;
    const Containers& tree_;
    ObjectRanges editable_, found_;      ///< what is found may be edited
    ObjectRanges groupObjects_, chosen_; ///< of groups: all objects, and those that are selected
    FoundGroups groups_;
};

ObjectRange selectableRange(const Session& session)
{
    return session.now().containers().rangeOf(session.entered.id());
}

} // namespace

ContainerId groupAt(const Session& session, std::size_t object)
{
    const Containers& tree = session.now().containers();
    ContainerId group = 0;
    for (ContainerId id = tree.containerOf(object);
         isGroup(tree, id) && !session.entered.contains(id); id = tree.parentOf(id))
        group = id;
    return group;
}

ObjectRanges unitAt(const Session& session, std::size_t object)
{
    const ContainerId group = groupAt(session, object);
    if (group == 0)
        return {object};
    const ObjectRange range = session.now().containers().rangeOf(group);
    return within(editableObjects(session.now()), range);
}

ObjectRanges unitsOf(const Session& session, const ObjectRanges& found, FoundGroups groups)
{
    return Widening(session, common(found, ObjectRanges(selectableRange(session))), groups)
        .in(session.entered.id());
}

ContainerId containerForNew(const Session& session)
{
    const Containers& tree = session.now().containers();
    for (const ContainerId id : {session.entered.id(), session.pen.layer})
        if (id != 0 && tree.contains(id))
            return id;
    return tree.childrenOf(0).back(); // another drawing, which the session follows in a moment
}

ContainerId layerForNew(const Session& session)
{
    const Containers& tree = session.now().containers();
    ContainerId id = containerForNew(session);
    while (tree[id].kind != Container::Kind::Layer)
        id = tree.parentOf(id);
    return id;
}

bool mayAddObjects(const Session& session)
{
    const Containers& tree = session.now().containers();
    const ContainerId into = containerForNew(session);
    return tree.shown(into) && !tree.locked(into);
}

QString nameForNew(const Session& session)
{
    return groupName(session.now().containers()[containerForNew(session)]);
}

ObjectRanges selectableObjects(const Session& session)
{
    return common(editableObjects(session.now()), ObjectRanges(selectableRange(session)));
}

QString selectionText(const Session& session)
{
    if (session.nodes.someSelected())
        return nodesText(session);
    const ObjectRanges& selection = session.selection();
    if (selection.empty())
        return Text::tr("nothing selected");
    const ContainerId group = groupAt(session, selection.first());
    const bool isGroup =
        group != 0 && selection == ObjectRanges(session.now().containers().rangeOf(group));
    if (selection.size() == 1 && !isGroup)
        return objectText(session, selection.first());
    const QString count = countText(selection.size());
    if (!isGroup)
        return Text::tr("%1 objects").arg(count);
    const QString text = selection.size() == 1 ? Text::tr("group of 1 object")
                                               : Text::tr("group of %1 objects").arg(count);
    const QString& name = session.now().containers()[group].name;
    return name.isEmpty() ? text : Text::tr("%1, %2").arg(name, text);
}

QString objectName(const Session& session, std::size_t object)
{
    const ObjectView view = session.now().objects()[object];
    const QString& id = view.particulars().id;
    return id.isEmpty() ? Text::tr("%1 %2").arg(nameOf(view),
                                                countText(session.document.numbers().of(object)))
                        : id;
}

QString objectText(const Session& session, std::size_t object)
{
    const ObjectView view = session.now().objects()[object];
    return view.particulars().id.isEmpty() ? objectName(session, object) : nameOf(view);
}

bool objectNameHas(const Session& session, std::size_t object, const QString& typed)
{
    if (objectName(session, object).contains(typed, Qt::CaseInsensitive))
        return true;
    const std::uint32_t number = session.document.numbers().of(object);
    const ObjectView view = session.now().objects()[object];
    return view.particulars().id.isEmpty()
           && Text::tr("%1 %2")
                  .arg(nameOf(view), QString::number(number))
                  .contains(typed, Qt::CaseInsensitive);
}

QString groupName(const Container& group)
{
    return group.name.isEmpty() ? Text::tr("Group") : group.name;
}

bool someGroupSelected(const Session& session)
{
    constexpr std::size_t mostLooks = 256;
    const Containers& tree = session.now().containers();
    const ObjectRanges& selection = session.selection();
    std::size_t looks = 0;
    ContainerId plain = 0; // holds no groups
    for (const ObjectRange& range : selection.ranges())
        for (std::size_t i = range.first; i < range.end;) {
            if (++looks > mostLooks)
                return true;
            if (groupAt(session, i) != 0) {
                if (without(unitAt(session, i), selection).empty())
                    return true;
                i = tree.rangeOf(groupAt(session, i)).end;
                continue;
            }
            const ContainerId around = tree.containerOf(i);
            if (around != plain && tree.childrenOf(around).empty())
                plain = around;
            i = around == plain ? tree.rangeOf(around).end : i + 1;
        }
    return false;
}

std::vector<ContainerId> selectedGroups(const Session& session)
{
    std::vector<ContainerId> groups;
    for (const TreeItem& item :
         TreeDraft(session.now(), session.selection(), session.entered.id()).chosen())
        if (item.id != 0)
            groups.push_back(item.id);
    return groups;
}

} // namespace app
