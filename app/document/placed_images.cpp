// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/placed_images.h"

namespace app {
namespace {

Containers withUnderlay(const Containers& tree, ContainerId layer, SharedUnderlay underlay)
{
    Container changed = tree[layer];
    changed.underlay = std::move(underlay);
    return tree.with(changed);
}

bool shows(const Containers& tree, const Underlay& image)
{
    for (const ContainerId id : tree.underlaid()) {
        Underlay other = *tree[id].underlay;
        other.svgId = image.svgId;
        if (tree.shown(id) && other == image)
            return true;
    }
    return false;
}

} // namespace

Containers withPlacedImages(Containers tree, const Placement& where)
{
    if (where.isIdentity())
        return tree;
    for (const ContainerId id : tree.underlaid()) {
        Underlay image = *tree[id].underlay;
        image.place.x *= where.scale;
        image.place.y *= where.scale;
        image.place.to = where(image.place.to);
        for (Point& corner : image.clip)
            corner = where(corner);
        tree = withUnderlay(tree, id, std::move(image));
    }
    return tree;
}

Containers withoutImagesOf(Containers tree, const Containers& other)
{
    for (const ContainerId id : tree.underlaid())
        if (shows(other, *tree[id].underlay))
            tree = withUnderlay(tree, id, {});
    return tree;
}

} // namespace app
