// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/controller.h"

#include <memory>

namespace ui {

/// A widget that shows the drawing: one of two kinds. It asks the controller for its pane's frames
/// and says how long they took; it knows nothing of tools. Controller and pane outlive it.
class Surface {
public:
    using Report = std::function<void(const FrameTimes&)>;
    virtual ~Surface() = default;
    virtual QWidget& widget() = 0;
    virtual void settle() {} ///< waits for full quality
    virtual void forget() {} ///< what it keeps for the next frame: it is not shown for a while
};

std::unique_ptr<Surface> makeRasterSurface(Controller& controller, const Pane& pane,
                                           Surface::Report report, QWidget* parent);
std::unique_ptr<Surface> makeGlSurface(Controller& controller, const Pane& pane,
                                       Surface::Report report, QWidget* parent);

} // namespace ui
