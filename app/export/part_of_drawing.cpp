// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/part_of_drawing.h"

#include "app/base/numbers.h"

namespace app {

Document onlyObjects(Document document, const ObjectRanges& objects)
{
    const ObjectRanges others =
        without(ObjectRanges(ObjectRange{0, document.objects().size()}), objects);
    Edit edit;
    for (const ObjectRange& range : others.ranges())
        edit.splices.push_back({std::uint32_t(range.first), std::uint32_t(range.size()), 0});
    Containers tree = document.containers().spliced(edit.splices);
    for (const ContainerId id : tree.inOrder()) // else removed with one around it
        if (tree.contains(id) && tree.rangeOf(id).empty() && tree.size() > 1)
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
