// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/two_points.h"

namespace ui {

/// Draws a shape that fits a rectangle, from corner to corner: Shift makes it a square, Alt starts
/// from its centre.
class CornerTool : public TwoPointTool {
protected:
    /// The corners are exactly, bit for bit, the pointer's positions.
    virtual app::Subpath pathIn(const clipping::Window& rectangle,
                                const app::Numbers& numbers) const = 0;
    virtual app::Recipe recipeIn(const clipping::Window& rectangle,
                                 const app::Numbers& numbers) const = 0;

    const app::GestureMeasure& measure(Qt::KeyboardModifiers modifiers) const override
    {
        return app::widthAndHeight(proportionOf(modifiers), anchorOf(modifiers));
    }
    app::Subpath path(const Gesture& gesture) const override
    {
        return pathIn(box(gesture), gesture.numbers);
    }
    app::Recipe recipe(const Gesture& gesture) const override
    {
        return recipeIn(box(gesture), gesture.numbers);
    }

private:
    static clipping::Window box(const Gesture& gesture)
    {
        return app::between(gesture.from, gesture.to, proportionOf(gesture.modifiers),
                            anchorOf(gesture.modifiers));
    }
};

} // namespace ui
