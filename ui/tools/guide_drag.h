// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/tool.h"

namespace ui {

/// Dragging a guide: a new one from a ruler, or one of the page. Dropped beside the drawing it is
/// removed.
class GuideDrag {
public:
    /// The shown guide that the pointer hits.
    static std::optional<std::size_t> guideAt(const app::Point& screen, const Workbench& bench);
    /// The chosen guide, if it still exists and is shown.
    static const app::Guide* chosen(const Workbench& bench);

    bool going() const { return now_.has_value(); }
    const std::optional<app::Guide>& now() const { return now_; }
    void start(int axis); ///< a new guide
    void start(std::size_t guide, const Workbench& bench);
    void proceed(const Pointer& pointer);
    void finish(Workbench& bench); ///< one step; chooses the guide
    void cancel() { now_.reset(); }

    /// The coordinate of the guide that is dragged, or of the chosen one.
    std::optional<app::Gauge> gauge(const Workbench& bench) const;
    QString hint(const Workbench& bench) const; ///< where it is; empty: no guide is meant
    void accept(const app::Point& point, Workbench& bench); ///< a typed coordinate
    static void remove(std::size_t guide, Workbench& bench);
    /// Paints the guide that is dragged, or the chosen one, stronger than the others.
    void paint(QPainter& painter, const Workbench& bench) const;

private:
    void put(double at, Workbench& bench);

    std::optional<app::Guide> now_;
    std::optional<std::size_t> old_; ///< its number; empty: it is a new one
    app::Point screen_{};            ///< the pointer
};

/// Paints a guide across the whole drawing.
void paintGuide(QPainter& painter, const Workbench& bench, const app::Guide& guide, double width);

} // namespace ui
