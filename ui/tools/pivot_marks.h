// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_ranges.h"
#include "ui/tools/tool.h"

namespace ui {

/// The point about which the selection is rotated, scaled and skewed, and the handle that rotates.
class PivotMarks {
public:
    enum class Mark : std::uint8_t { None, Rotation, Pivot };

    /// The middle of the selection, unless it was put elsewhere.
    app::Point pivot(const Workbench& bench) const;
    void put(const app::Point& pivot, const Workbench& bench);
    /// What a press at a place on the screen drags.
    Mark at(const app::Point& screen, const Workbench& bench) const;
    void paint(QPainter& painter, const Workbench& bench) const;
    static void paintPivot(QPainter& painter, const QPointF& at, const Look& look);

private:
    bool isShown(const Workbench& bench) const;

    std::optional<app::Point> pivot_; ///< empty: the middle of the selection
    app::ObjectRanges selection_;     ///< the one to which it belongs,
    clipping::Window bounds_{};       ///< as it was
};

} // namespace ui
