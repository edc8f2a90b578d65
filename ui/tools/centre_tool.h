// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/recipe_outline.h"
#include "ui/tools/two_points.h"

#include <algorithm>

namespace ui {

/// Draws a regular polygon or a star from its centre to a corner. The third number is that of the
/// corners, which the arrow keys Up and Down change, too.
class CentreTool : public TwoPointTool {
public:
    bool key(QKeyEvent& event, Workbench&) override
    {
        const int by = event.key() == Qt::Key_Up ? 1 : event.key() == Qt::Key_Down ? -1 : 0;
        if (!gesture_ || by == 0)
            return false;
        double& corners = gesture_->numbers[2];
        corners = std::clamp(corners + by, 3.0, 1000.0);
        return true;
    }

protected:
    app::Subpath path(const Gesture& gesture) const override
    {
        return *app::outlineOf(recipe(gesture));
    }
    app::Recipe recipe(const Gesture& gesture) const override { return starOf(gesture); }
    virtual app::StarRecipe starOf(const Gesture& gesture) const = 0;

    static int cornersOf(const Gesture& gesture) { return std::max(3, int(gesture.numbers[2])); }
};

} // namespace ui
