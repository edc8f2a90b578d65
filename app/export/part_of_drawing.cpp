// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/part_of_drawing.h"

#include "app/base/numbers.h"

#include <set>

namespace app {

Document onlyImagesIn(Document document, ContainerId layer)
{
    Containers tree = document.containers();
    if (!tree.isUnderlaid())
        return document;
    for (const ContainerId id : tree.underlaid()) {
        ContainerId around = id;
        while (around != 0 && around != layer)
            around = tree.parentOf(around);
        if (around != 0)
            continue;
        Container without = tree[id];
        without.underlay = {};
        tree = tree.with(without);
    }
    document.apply({.containers = std::move(tree)});
    return document;
}

Document onlyObjects(Document document, const ObjectRanges& objects)
{
    const ObjectRanges others =
        without(ObjectRanges(ObjectRange{0, document.objects().size()}), objects);
    Edit edit;
    for (const ObjectRange& range : others.ranges())
        edit.splices.push_back({std::uint32_t(range.first), std::uint32_t(range.size()), 0});
    Containers tree = document.containers().spliced(edit.splices);
    std::set<ContainerId> withImages{0};
    for (ContainerId id : tree.underlaid())
        for (; withImages.insert(id).second;)
            id = tree.parentOf(id);
    for (const ContainerId id : tree.inOrder()) // else removed with one around it
        if (tree.contains(id) && tree.rangeOf(id).empty() && tree.size() > 1
            && !withImages.contains(id))
            tree = tree.removed(id);
    edit.containers = std::move(tree);
    document.apply(edit);
    return document;
}

Page paperAround(Page page, const clipping::Window& rectangle)
{
    const double unit = page.millimetresPerUnit();
    // Of the paper: that of the drawing's lengths may be none that SVG knows.
    const Unit shown = infoOf(page.width.unit).millimetres > 0 ? page.width.unit : Unit::Px;
    page.margins = {}; // they may leave nothing of it
    page.min = rectangle.min;
    page.size = rectangle.max - rectangle.min;
    page.width = {inUnit(page.size.x, shown, unit), shown};
    page.height = {inUnit(page.size.y, shown, unit), shown};
    return page;
}

} // namespace app
