// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/layer_steps.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/commands/rearrange_objects.h"
#include "app/commands/set_containers.h"
#include "app/commands/set_hidden.h"
#include "app/document/hidden_objects.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace app {
namespace {

QString sentenceOn(MoveFault fault)
{
    static const std::array all{
        QString(), Text::tr("The layer was removed meanwhile."),
        Text::tr("A layer cannot be moved into itself or into a layer inside it."),
        Text::tr("A layer cannot be moved into a group, only into another layer."),
        Text::tr("A group cannot be moved out of all layers. Move it into another layer.")};
    return all[std::size_t(fault)];
}

std::vector<ContainerId> layersIn(const Containers& tree, ContainerId parent)
{
    auto layers = tree.childrenOf(parent);
    std::erase_if(layers, [&](ContainerId id) { return tree[id].kind != Container::Kind::Layer; });
    return layers;
}

/// The container directly below a layer in the list of its siblings; 0: none.
ContainerId belowOf(const std::vector<ContainerId>& siblings, ContainerId layer)
{
    const auto at = std::ranges::find(siblings, layer);
    return at == siblings.begin() || at == siblings.end() ? 0 : *std::prev(at);
}

bool isAround(const Containers& tree, ContainerId outer, ContainerId inner)
{
    while (inner != 0 && inner != outer)
        inner = tree.parentOf(inner);
    return inner == outer;
}

} // namespace

std::optional<ContainerPlace> placeAfter(const Containers& tree, ContainerId layer, LayerStep step)
{
    const ContainerId parent = tree.parentOf(layer);
    const auto siblings = layersIn(tree, parent);
    const auto at = std::ranges::find(siblings, layer);
    const bool topmost = std::next(at) == siblings.end();
    if (step == LayerStep::Up && !topmost)
        return ContainerPlace{parent, *std::next(at)};
    if (step == LayerStep::Up && parent != 0)
        return ContainerPlace{tree.parentOf(parent), parent};
    if (step == LayerStep::Inward && !topmost)
        return ContainerPlace{*std::next(at), 0};
    const bool lowest = at == siblings.begin();
    if (step == LayerStep::Down && !lowest)
        return ContainerPlace{parent, belowOf(siblings, *std::prev(at))};
    if (parent != 0 && (step == LayerStep::Down || step == LayerStep::Outward)) {
        const ContainerId around = tree.parentOf(parent);
        return ContainerPlace{around, belowOf(layersIn(tree, around), parent)};
    }
    return std::nullopt;
}

ContainerPlace placeBelow(const Containers& tree, ContainerId layer)
{
    if (!layersIn(tree, layer).empty())
        return {layer, {}};
    const ContainerId parent = tree.parentOf(layer);
    return {parent, belowOf(layersIn(tree, parent), layer)};
}

void moveLayer(Session& session, ContainerId layer, const ContainerPlace& place)
{
    if (place.below == layer || place.parent == layer)
        return; // dropped onto itself
    const MoveFault fault = faultOf(session.now().containers(), layer, place);
    if (fault != MoveFault::None) {
        emit session.refused(sentenceOn(fault));
        return;
    }
    auto moved = movedContainer(session.now(), layer, place, session.selection());
    if (!moved || !moved->changes())
        return;
    const QString text = Text::tr("Move layer %1").arg(session.now().containers()[layer].name);
    session.history.push(new RearrangeObjects(session.document, std::move(moved->edit), text));
    session.select(common(moved->chosen, editableObjects(session.now())));
}

void moveLayer(Session& session, ContainerId layer, LayerStep step)
{
    if (const auto place = placeAfter(session.now().containers(), layer, step))
        moveLayer(session, layer, *place);
}

void showOnlyLayer(Session& session, ContainerId layer)
{
    const Containers& tree = session.now().containers();
    Containers alone = tree, all = tree;
    const auto show = [](Containers& in, ContainerId id, bool visible) {
        if (in[id].visible == visible)
            return;
        Container changed = in[id];
        changed.visible = visible;
        in = in.with(changed);
    };
    for (const ContainerId id : tree.inOrder()) {
        if (tree[id].kind != Container::Kind::Layer)
            continue;
        const bool related = isAround(tree, id, layer) || isAround(tree, layer, id);
        show(alone, id, related && (id == layer || isAround(tree, id, layer) || tree[id].visible));
        show(all, id, true);
    }
    if (alone == all)
        return; // the only layer
    const bool isAlone = alone == tree;
    session.history.push(
        new SetContainers(session.document, isAlone ? all : alone,
                          isAlone ? Text::tr("Show all layers")
                                  : Text::tr("Show only layer %1").arg(tree[layer].name)));
}

namespace {

Containers with(Containers tree, std::span<const ContainerId> ids, bool Container::*mark, bool on)
{
    for (const ContainerId id : ids) {
        Container changed = tree[id];
        changed.*mark = on;
        tree = tree.with(changed);
    }
    return tree;
}

} // namespace

void show(Session& session, const TreeRows& rows, bool visible)
{
    const Containers& tree = session.now().containers();
    TreeRows changing;
    std::ranges::copy_if(rows.containers, std::back_inserter(changing.containers),
                         [&](ContainerId id) { return tree[id].visible != visible; });
    changing.objects = without(rows.objects, tree.lockedRanges());
    if (changing.size() == 0)
        return;
    Edit edit = changed(session.now(), changing.objects,
                        [&](ObjectRow& object, StyleTable&) { object.hidden = !visible; });
    if (!changing.containers.empty())
        edit.containers = with(tree, changing.containers, &Container::visible, visible);
    const QString text = visible ? Text::tr("Show %1 rows") : Text::tr("Hide %1 rows");
    session.history.push(new EditCommand(SetHidden::row, session.document, std::move(edit),
                                         text.arg(countText(rows.size()))));
}

void lock(Session& session, const TreeRows& rows, bool locked)
{
    const Containers& tree = session.now().containers();
    Containers after = with(tree, rows.containers, &Container::locked, locked);
    if (after == tree)
        return;
    const QString text = locked ? Text::tr("Lock %1 rows") : Text::tr("Unlock %1 rows");
    session.history.push(new SetContainers(session.document, std::move(after),
                                           text.arg(countText(rows.containers.size()))));
}

/// Layers beyond the limit of a file would be merged when the file is opened again.
static bool hasRoomForALayer(const Containers& containers)
{
    const auto isLayer = [&](ContainerId id) {
        return containers[id].kind == Container::Kind::Layer;
    };
    return std::size_t(std::ranges::count_if(containers.inOrder(), isLayer))
           < Containers::mostLayers;
}

bool addLayer(Session& session, const QString& name)
{
    const Containers& containers = session.now().containers();
    if (!hasRoomForALayer(containers)) {
        emit session.refused(
            Text::tr("No layer was added. This drawing has %1 layers, and a file cannot "
                     "hold more. Delete a layer first.")
                .arg(countText(Containers::mostLayers)));
        return false;
    }
    const std::size_t top = containers.objects();
    auto more = containers.inserted({.name = name}, 0, containers.childrenOf(0).size(), {top, top});
    if (more)
        session.history.push(
            new SetContainers(session.document, std::move(*more), Text::tr("Add layer")));
    else
        emit session.refused(
            Text::tr("No layer was added. This drawing has %1 layers and groups, and "
                     "cannot take more. Delete a layer first.")
                .arg(countText(Containers::mostContainers)));
    return more.has_value();
}

} // namespace app
