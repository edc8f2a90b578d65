// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/limited_steps.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/commands/set_containers.h"

#include <algorithm>

namespace app {

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
