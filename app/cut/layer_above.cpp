// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/layer_above.h"

namespace app {

std::pair<Containers, ContainerId> withLayerAbove(const Document& document, const QString& name)
{
    const Containers& tree = document.containers();
    const auto layers = tree.childrenOf(0);
    const std::size_t end = document.objects().size();
    Container layer;
    layer.name = name;
    if (layers.size() < Containers::mostLayers)
        if (auto with = tree.inserted(layer, 0, layers.size(), {end, end}))
            return {std::move(*with), tree.nextId()};
    return {tree, layers.back()};
}

} // namespace app
