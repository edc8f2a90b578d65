// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/backend.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

namespace ui {

// Platforms such as offscreen make a context where there is a DISPLAY, and crash on showing it.
GlProbe probeGl()
{
    static const QStringList able{"xcb", "wayland", "wayland-egl", "windows", "cocoa"};
    if (!able.contains(QGuiApplication::platformName()))
        return {};
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    QOpenGLContext context;
    context.setFormat(format);
    if (!context.create() || context.format().version() < qMakePair(3, 3))
        return {};
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    if (!surface.isValid() || !context.makeCurrent(&surface))
        return {};
    const auto* name = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
    const QString renderer = QString::fromLatin1(name ? name : "");
    const bool software = renderer.contains("llvmpipe", Qt::CaseInsensitive)
                          || renderer.contains("softpipe", Qt::CaseInsensitive)
                          || renderer.contains("software", Qt::CaseInsensitive);
    return {true, software, renderer.section(' ', 0, 2).section('(', 0, 0).trimmed()};
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
