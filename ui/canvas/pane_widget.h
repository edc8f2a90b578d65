// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/backend.h"
#include "ui/canvas/pane_heading.h"
#include "ui/canvas/surface.h"

namespace ui {

/// A pane: its heading, if shown, above the surface that shows its drawing.
class PaneWidget : public QWidget {
    Q_OBJECT

public:
    PaneWidget(Controller& controller, Backend backend, QWidget* parent);

    enum class Heading : std::uint8_t { Shown, None };
    void show(const Pane& pane, Heading heading);
    /// Hides the pane and frees what is expensive to keep.
    void rest();

    const Pane& pane() const { return pane_; }
    PaneHeading& heading() { return *heading_; }
    Surface& surface() { return *surface_; }
    void settle(); ///< waits for full quality and for the differences

signals:
    void frameShown(const app::FrameTimes& times);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void place();
    void followWindow();
    bool clipsItself() const; ///< not another algorithm in its place

    const app::Session& session_;
    app::LiveDifferences fromExact_;
    Pane pane_;
    PaneHeading* heading_;
    std::unique_ptr<Surface> surface_;
};

} // namespace ui
