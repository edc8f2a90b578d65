// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/tool.h"

namespace ui {

/// Resizes the selection by a handle of its bounding box. Shift keeps the proportions, Alt the
/// centre; typed numbers hold.
class BoxResize {
public:
    void start(app::Handle handle, const clipping::Window& bounds, const Pointer& pressed);
    bool going() const { return now_.has_value(); }
    void proceed(const Pointer& pointer);
    void finish(Workbench& bench);
    void accept(const app::GestureEnd& end, Workbench& bench);
    void cancel() { now_.reset(); }
    clipping::Window target() const; ///< the selection's bounds after the drag
    app::Gauge gauge(const Workbench& bench) const;
    void paint(QPainter& painter, const Workbench& bench) const;

private:
    struct State {
        app::Handle handle;
        clipping::Window bounds;
        app::Point shift; ///< from the pointer to the handle
        app::GestureEnd end;
        Qt::KeyboardModifiers modifiers;
    };
    app::Point fixed() const; ///< the point that stays
    const app::GestureMeasure& measure() const;

    std::optional<State> now_;
};

} // namespace ui
