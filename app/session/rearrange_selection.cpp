// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/rearrange_selection.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/commands/rearrange_objects.h"
#include "app/document/regrouping.h"
#include "app/scene/bounds.h"
#include "app/session/units.h"

#include <algorithm>

namespace app {
namespace {

void pushRearranged(Session& session, std::optional<Rearranged> result, const QString& undoText,
                    const QString& unchanged)
{
    if (!result) {
        emit session.refused(
            Text::tr(
                "Nothing was changed: a drawing can have %1 layers and groups, nested %2 deep.")
                .arg(countText(Containers::mostContainers),
                     countText(std::size_t(Containers::deepest))));
        return;
    }
    if (!result->changes()) {
        emit session.refused(unchanged);
        return;
    }
    session.history.push(new RearrangeObjects(session.document, std::move(result->edit), undoText));
    session.select(std::move(result->chosen));
}

bool overlap(const clipping::Window& a, const clipping::Window& b)
{
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

struct StackingText {
    QString undo, unchanged;
};

StackingText textOf(Stacking how)
{
    const QString front = Text::tr("The selection is already in front."),
                  back = Text::tr("The selection is already at the back.");
    switch (how) {
    case Stacking::Raise:
        return {Text::tr("Raise selection"),
                Text::tr("Nothing in front of the selection overlaps it.")};
    case Stacking::Lower:
        return {Text::tr("Lower selection"), Text::tr("Nothing behind the selection overlaps it.")};
    case Stacking::ToFront:
        return {Text::tr("Bring to front"), front};
    case Stacking::ToBack:
        return {Text::tr("Send to back"), back};
    }
    return {};
}

} // namespace

void groupSelection(Session& session)
{
    pushRearranged(session, grouped(session.now(), session.selection(), session.entered.id()),
                   Text::tr("Group"), Text::tr("Nothing is selected. Select objects first."));
}

void ungroupSelection(Session& session)
{
    pushRearranged(session, ungrouped(session.now(), session.selection(), session.entered.id()),
                   Text::tr("Ungroup"), Text::tr("No group is selected. Click a group first."));
}

// The boxes are computed here, because the draft knows no lines.
void stackSelection(Session& session, Stacking how)
{
    const SceneLines& lines = session.scene.lines();
    const auto& box = session.selectionBounds();
    const auto overlaps = [&](const ObjectRange& objects) {
        const auto other = box ? boundsOf(lines, ObjectRanges(objects)) : std::nullopt;
        return other && overlap(*box, *other);
    };
    const auto [undo, unchanged] = textOf(how);
    pushRearranged(session,
                   stacked(session.now(), session.selection(), session.entered.id(), how, overlaps),
                   undo, unchanged);
}

/// Whether objects may be moved into a layer or group; if not, the session says why.
static bool takesObjects(Session& session, ContainerId into)
{
    const Containers& tree = session.now().containers();
    if (tree.shown(into) && !tree.locked(into))
        return true;
    const QString sentence = tree[into].kind == Container::Kind::Layer
                                 ? Text::tr("The layer %1 is locked or hidden, so nothing was "
                                            "moved to it. Unlock and show it first.")
                                 : Text::tr("The group %1 is locked or hidden, so nothing was "
                                            "moved to it. Unlock and show it first.");
    emit session.refused(sentence.arg(groupName(tree[into])));
    return false;
}

void moveSelectionTo(Session& session, ContainerId layer)
{
    const QString name = session.now().containers()[layer].name;
    if (!takesObjects(session, layer))
        return;
    pushRearranged(session,
                   movedTo(session.now(), session.selection(), session.entered.id(), layer),
                   Text::tr("Move to layer %1").arg(name),
                   Text::tr("The selection is already on top of this layer."));
}

void moveSelectionBetween(Session& session, ContainerId into, std::size_t at)
{
    if (session.selection().empty() || !takesObjects(session, into))
        return;
    const Containers& tree = session.now().containers();
    const ContainerId group = groupAt(session, session.selection().first());
    const ContainerId now =
        group != 0 ? tree.parentOf(group) : tree.containerOf(session.selection().first());
    const QString name = groupName(tree[into]);
    pushRearranged(session,
                   movedBetween(session.now(), session.selection(), session.entered.id(), into, at),
                   (into == now                                 ? Text::tr("Change the order in %1")
                    : tree[into].kind == Container::Kind::Layer ? Text::tr("Move to layer %1")
                                                                : Text::tr("Move to group %1"))
                       .arg(name),
                   Text::tr("The selection is already there."));
}

std::vector<ContainerId> usableLayers(const Session& session)
{
    const Containers& tree = session.now().containers();
    std::vector<ContainerId> layers;
    for (const ContainerId id : tree.inOrder())
        if (tree[id].kind == Container::Kind::Layer && tree.shown(id) && !tree.locked(id))
            layers.insert(layers.begin(), id);
    return layers;
}

void moveSelectionBy(Session& session, int by)
{
    if (session.selection().empty())
        return;
    const auto layers = usableLayers(session); // topmost first
    const ContainerId now = session.now().containers().layerOf(
        by > 0 ? session.selection().last() : session.selection().first());
    const auto to = std::ranges::find(layers, now) - layers.begin() - by;
    if (to < 0 || to >= std::ptrdiff_t(layers.size()))
        emit session.refused(
            by > 0 ? Text::tr("No layer above is shown and unlocked. Show or unlock one first.")
                   : Text::tr("No layer below is shown and unlocked. Show or unlock one first."));
    else
        moveSelectionTo(session, layers[std::size_t(to)]);
}

} // namespace app
