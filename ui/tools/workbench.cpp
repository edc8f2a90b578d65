// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool.h"

namespace ui {

app::MovedSnap Workbench::moved(const app::OwnPoints& own, const app::Point& by,
                                Qt::KeyboardModifiers modifiers, const app::ObjectRanges& without,
                                app::SnapTo allowed) const
{
    const app::SnapTo to = snapTo & allowed;
    if (to == app::SnapTo::Nothing || modifiers & Qt::ControlModifier)
        return {by};
    return snapper.moved(own, by,
                         {.pointer = {},
                          .radius = inDrawing(snapReach),
                          .to = to,
                          .without = without,
                          .seen = view.visible()});
}

} // namespace ui
