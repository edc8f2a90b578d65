// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/open_gl.h"

#include <QGuiApplication>
#include <QOpenGLFunctions>

namespace app {

// Platforms such as offscreen create a context if there is a DISPLAY, and crash when they show it.
bool platformHasGl()
{
    static const QStringList able{"xcb", "wayland", "wayland-egl", "windows", "cocoa"};
    return qobject_cast<QGuiApplication*>(QCoreApplication::instance())
           && able.contains(QGuiApplication::platformName());
}

QSurfaceFormat coreFormat()
{
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    return format;
}

std::unique_ptr<QOpenGLContext> contextOn(QOffscreenSurface& surface)
{
    auto context = std::make_unique<QOpenGLContext>();
    context->setFormat(coreFormat());
    const bool usable = surface.isValid() && context->create()
                        && context->format().version() >= qMakePair(3, 3)
                        && context->makeCurrent(&surface);
    return usable ? std::move(context) : nullptr;
}

QString rendererOf(QOpenGLContext& context)
{
    const auto* name = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
    const QString all = QString::fromLatin1(name ? name : "");
    return all.section(u' ', 0, 2).section(u'(', 0, 0).trimmed();
}

bool isSoftware(const QString& renderer)
{
    for (const char* word : {"llvmpipe", "softpipe", "software"})
        if (renderer.contains(QLatin1StringView(word), Qt::CaseInsensitive))
            return true;
    return false;
}

} // namespace app
