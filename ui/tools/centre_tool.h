// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/recipe_outline.h"
#include "app/drawing/centred_shapes.h"
#include "ui/tools/two_points.h"

#include <algorithm>

namespace ui {

/// Up and Down change the number of corners, the third of the numbers; false: it is another key.
inline bool changesCorners(const QKeyEvent& event, app::Numbers& numbers)
{
    const int by = event.key() == Qt::Key_Up ? 1 : event.key() == Qt::Key_Down ? -1 : 0;
    numbers[2] =
        by == 0 ? numbers[2] : std::clamp(numbers[2] + by, app::leastCorners, app::mostCorners);
    return by != 0;
}

/// Draws a regular polygon or a star from its centre to a corner. The third number is that of the
/// corners, which the arrow keys Up and Down change, too.
class CentreTool : public TwoPointTool, public TakesKeys {
public:
    bool key(QKeyEvent& event, Workbench&) override
    {
        return gesture_ && changesCorners(event, gesture_->numbers);
    }

protected:
    app::Subpath path(const Gesture& gesture) const override
    {
        return *app::outlineOf(recipe(gesture));
    }
    app::Recipe recipe(const Gesture& gesture) const override { return starOf(gesture); }
    virtual app::StarRecipe starOf(const Gesture& gesture) const = 0;
};

} // namespace ui
