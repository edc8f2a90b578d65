// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/drag.h"

#include <utility>

namespace ui {

/// The point about which the selection is rotated, scaled and skewed, and the handle that rotates.
class PivotMarks {
public:
    enum class Mark : std::uint8_t { None, Rotation, Pivot };

    /// What a press at a place on the screen drags.
    static Mark at(const app::Point& screen, const Workbench& bench);
    static QString hint(Mark mark); ///< empty for Mark::None
    /// Of a line, a text or a small selection only if the pointer is near it.
    static void paint(QPainter& painter, const Workbench& bench, bool near);
    static QPointF rotationHandle(const Workbench& bench); ///< on the screen; something is selected
    static void paintPivot(QPainter& painter, const QPointF& at, const Look& look);
};

/// Puts the pivot of the selection elsewhere.
class PivotDrag final : public Drag {
public:
    void start() { going_ = true; }
    bool going() const override { return going_; }
    void proceed(const Pointer& pointer, Workbench& bench) override
    {
        bench.session.pivot.put(pointer.position);
    }
    bool finish(const Pointer& pointer, Workbench& bench) override
    {
        proceed(pointer, bench);
        return std::exchange(going_, false);
    }
    void cancel(Workbench&) override { going_ = false; }
    void limit(app::SnapQuery&) const override {}

private:
    bool going_ = false;
};

} // namespace ui
