// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/backend.h"

#include "app/view/open_gl.h"
#include "ui/look/text.h"

namespace ui {

GlProbe probeGl()
{
    if (!app::platformHasGl())
        return {};
    QOffscreenSurface surface;
    surface.setFormat(app::coreFormat());
    surface.create();
    const auto context = app::contextOn(surface);
    if (!context)
        return {};
    const QString renderer = app::rendererOf(*context);
    return {true, app::isSoftware(renderer), renderer};
}

Choice chooseBackend(Backend wish, const GlProbe& probe)
{
    if (wish == Backend::Raster)
        return {Backend::Raster,
                Text::tr("Raster canvas (painted by the processor), as requested")};
    if (!probe.usable)
        return {
            Backend::Raster,
            Text::tr("Raster canvas (painted by the processor): OpenGL 3.3 is not available here")};
    if (wish == Backend::OpenGL)
        return {Backend::OpenGL, Text::tr("OpenGL canvas, as requested: %1").arg(probe.renderer)};
    if (probe.software)
        return {Backend::Raster,
                Text::tr("Raster canvas (painted by the processor): OpenGL would also "
                         "use the processor here (%1), and would be slower")
                    .arg(probe.renderer)};
    return {Backend::OpenGL, Text::tr("OpenGL canvas: %1").arg(probe.renderer)};
}

} // namespace ui
