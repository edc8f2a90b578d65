// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/frame_times.h"
#include "ui/canvas/backend.h"
#include "ui/canvas/controller.h"
#include "ui/canvas/pane_heading.h"

#include <memory>

namespace ui {

/// A widget that shows the drawing: raster or OpenGL. It asks the controller for its pane's frames
/// and reports their times; it does not depend on tools. Controller and pane must outlive it.
class Surface {
public:
    using Report = std::function<void(const app::FrameTimes&)>;
    virtual ~Surface() = default;
    virtual QWidget& widget() = 0;
    virtual void settle() {} ///< waits for full quality
    virtual void forget() {} ///< frees what it keeps for the next frame, because it is hidden
};

std::unique_ptr<Surface> makeRasterSurface(Controller& controller, const Pane& pane,
                                           Surface::Report report, QWidget* parent);
std::unique_ptr<Surface> makeGlSurface(Controller& controller, const Pane& pane,
                                       Surface::Report report, QWidget* parent);

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
    void sayWhereItClips();
    void sayWhatIsChosen();

    const Controller& controller_;
    const app::Session& session_;
    app::LiveDifferences fromExact_;
    Pane pane_;
    PaneHeading* heading_;
    std::unique_ptr<Surface> surface_;
};

} // namespace ui
