// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/last_drawn.h"
#include "ui/tools/shape_drawing.h"

namespace ui {

/// Draws a shape that fits a rectangle, dragged from corner to corner: Shift makes it a square, Alt
/// starts from its centre.
class CornerTool : public Tool {
public:
    void press(const Pointer& pointer, Workbench& bench) override
    {
        to_ = pointer;
        if (from_)
            return finish(bench);
        last_.forget();
        from_ = pointer.position;
        pressed_ = pointer.screen;
    }
    void move(const Pointer& pointer, Workbench&) override { to_ = pointer; }
    void release(const Pointer& pointer, Workbench& bench) override
    {
        to_ = pointer;
        const auto pressed = std::exchange(pressed_, std::nullopt);
        if (pressed && from_ && dragged(*pressed, pointer))
            finish(bench);
    }
    void cancel(Workbench& bench) override
    {
        from_.reset();
        pressed_.reset();
        last_.restore(bench);
    }
    std::optional<app::Gauge> gauge(const Workbench& bench) const override
    {
        if (!from_)
            return gaugeOfStart(bench);
        const auto& measure =
            app::widthAndHeight(proportionOf(to_.modifiers), anchorOf(to_.modifiers));
        app::Gauge gauge = gaugeFrom(*from_, measure, bench);
        gauge.aim = last_.end();
        return gauge;
    }
    void accept(const app::Point& point, Workbench& bench) override
    {
        to_.position = point;
        if (from_)
            finish(bench);
        else
            from_ = point;
    }
    void reopen(Workbench& bench) override
    {
        const auto gesture = last_.reopen(bench);
        if (!gesture)
            return;
        from_ = gesture->from;
        to_.position = gesture->to;
        to_.modifiers = modifiers_;
    }
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
        return app::between(*from_, to_.position, proportionOf(to_.modifiers),
                            anchorOf(to_.modifiers));
    }
    void finish(Workbench& bench)
    {
        const app::Point from = *from_, to = to_.position;
        if (from.x == to.x || from.y == to.y)
            return; // no area yet
        last_.discard();
        modifiers_ = to_.modifiers;
        draw(bench, {pathIn(rectangle())}, undoText(), recipeIn(rectangle()));
        cancel(bench);
        last_.remember({from, to}, bench);
    }

    std::optional<app::Point> from_;
    std::optional<app::Point> pressed_; ///< on the screen; empty: the button is up
    Pointer to_{};
    Qt::KeyboardModifiers modifiers_; ///< of the last gesture
    LastDrawn last_;
};

} // namespace ui
