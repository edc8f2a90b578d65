// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/shape_drawing.h"

namespace ui {

/// Draws a shape that fits a rectangle, dragged from corner to corner: Shift makes it a square, Alt
/// starts from its centre.
class CornerTool : public Tool {
public:
    void press(const Pointer& pointer, Workbench&) override { from_ = to_ = pointer; }
    void move(const Pointer& pointer, Workbench&) override { to_ = pointer; }
    void release(const Pointer& pointer, Workbench& bench) override
    {
        to_ = pointer;
        if (from_ && dragged(from_->screen, pointer))
            draw(bench, {pathIn(rectangle())}, undoText(), recipeIn(rectangle()));
        from_.reset();
    }
    void cancel(Workbench&) override { from_.reset(); }
    bool busy() const override { return from_.has_value(); }
    bool draws() const override { return true; }
    void paint(QPainter& painter, const Workbench& bench) const override
    {
        if (from_)
            preview(painter, bench, pathIn(rectangle()));
    }

protected:
    /// The corners are exactly, bit for bit, the pointer's positions.
    virtual app::Subpath pathIn(const clipping::Window& rectangle) const = 0;
    virtual app::Recipe recipeIn(const clipping::Window& rectangle) const = 0;
    virtual QString undoText() const = 0;

private:
    clipping::Window rectangle() const
    {
        return app::between(from_->position, to_.position, proportionOf(to_.modifiers),
                            anchorOf(to_.modifiers));
    }

    std::optional<Pointer> from_;
    Pointer to_{};
};

} // namespace ui
