// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/controller.h"

#include <memory>

namespace ui {

/// The widget that shows the drawing: one of two. It asks the controller for frames and says how
/// long they took; it knows nothing of tools.
class Surface {
public:
    using Report = std::function<void(const FrameTimes&)>;
    virtual ~Surface() = default;
    virtual QWidget& widget() = 0;
    virtual void settle() {} ///< waits for full quality
};

std::unique_ptr<Surface> makeRasterSurface(Controller& controller, Surface::Report report,
                                           QWidget* parent);
std::unique_ptr<Surface> makeGlSurface(Controller& controller, Surface::Report report,
                                       QWidget* parent);

} // namespace ui
