// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/two_point_gesture.h"

namespace ui {

/// Draws an object from one point to another.
class TwoPointTool : public TwoPointGesture {
public:
    void paint(QPainter& painter, const Workbench& bench) const override
    {
        if (gesture_)
            preview(painter, bench, path(*gesture_));
    }

protected:
    virtual app::Subpath path(const Gesture& gesture) const = 0;
    virtual app::Recipe recipe(const Gesture&) const { return {}; }
    virtual QString undoText() const = 0;
    /// The name of the finished step, with the sizes that tell it from others.
    virtual QString historyText(const Workbench&) const { return undoText(); }
    void make(Workbench& bench) override
    {
        draw(bench, {path(*gesture_)}, historyText(bench), recipe(*gesture_));
        bench.lastPoint = gesture_->to;
    }
};

} // namespace ui
