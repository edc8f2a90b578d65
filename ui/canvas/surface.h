// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/frame_times.h"
#include "ui/canvas/controller.h"

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

} // namespace ui
