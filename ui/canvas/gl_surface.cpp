// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/surface.h"
namespace ui {
std::unique_ptr<Surface> makeGlSurface(Controller& controller, Surface::Report report,
                                       QWidget* parent)
{
    return makeRasterSurface(controller, std::move(report), parent);
}
} // namespace ui
