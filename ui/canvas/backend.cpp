// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/backend.h"

#include "app/view/open_gl.h"

#include <QCoreApplication>

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
    const auto tr = [](const char* text) { return QCoreApplication::translate("Canvas", text); };
    if (wish == Backend::Raster)
        return {Backend::Raster, tr("Raster canvas: asked for")};
    if (!probe.usable)
        return {Backend::Raster, tr("Raster canvas: OpenGL 3.3 is not available here")};
    if (wish == Backend::OpenGL)
        return {Backend::OpenGL, tr("OpenGL canvas: asked for (%1)").arg(probe.renderer)};
    if (probe.software)
        return {Backend::Raster,
                tr("Raster canvas: OpenGL is done in software here (%1), and raster is faster")
                    .arg(probe.renderer)};
    return {Backend::OpenGL, tr("OpenGL canvas: %1").arg(probe.renderer)};
}

} // namespace ui
