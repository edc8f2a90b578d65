// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/drag.h"

namespace ui {

/// Dragging a guide: a new one from a ruler, or one of the page. Dropped beside the drawing it is
/// removed.
class GuideDrag final : public Drag {
public:
    /// The shown guide that the pointer hits.
    static std::optional<std::size_t> guideAt(const app::Point& screen, const Workbench& bench);
    /// The chosen guide, if it still exists and is shown.
    static const app::Guide* chosen(const Workbench& bench);

    void start(int axis); ///< a new guide
    void start(std::size_t guide, const Workbench& bench);
    bool going() const override { return now_.has_value(); }
    void proceed(const Pointer& pointer, Workbench& bench) override;
    bool finish(const Pointer& pointer, Workbench& bench) override; ///< chooses the guide
    void finish(Workbench& bench);                                  ///< where the pointer was last
    void cancel(Workbench&) override { now_.reset(); }
    /// Paints the guide that is dragged, or the chosen one, stronger than the others.
    void paint(QPainter& painter, const Workbench& bench) const override;
    /// The coordinate of the guide that is dragged, or of the chosen one.
    std::optional<app::Gauge> gauge(const Workbench& bench) const override;
    void accept(const app::GestureEnd& end, Workbench& bench) override;
    void limit(app::SnapQuery&) const override {}
    QString hint(const Workbench& bench) const; ///< where it is; empty: no guide is meant
    static void remove(std::size_t guide, Workbench& bench);

private:
    void put(double at, Workbench& bench);

    std::optional<app::Guide> now_;
    std::optional<std::size_t> old_; ///< its number; empty: it is a new one
    app::Point screen_{};            ///< the pointer
};

/// Paints a guide across the whole drawing.
void paintGuide(QPainter& painter, const Workbench& bench, const app::Guide& guide, double width);

} // namespace ui
