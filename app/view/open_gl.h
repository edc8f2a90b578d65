// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOffscreenSurface>
#include <QOpenGLContext>

#include <memory>

// OpenGL 3.3 core, where it can be used at all.

namespace app {

/// Whether it is worth trying: other platforms have no OpenGL, or make a context that crashes when
/// it draws. Without a QGuiApplication it never is.
bool platformHasGl();

QSurfaceFormat coreFormat();

/// A new context that is current on the surface, or null.
std::unique_ptr<QOpenGLContext> contextOn(QOffscreenSurface& surface);

/// "llvmpipe", "Mesa Intel UHD": who draws for the current context.
QString rendererOf(QOpenGLContext& context);

/// Whether a renderer of that name draws with the processor.
bool isSoftware(const QString& renderer);

} // namespace app
