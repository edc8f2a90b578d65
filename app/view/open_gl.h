// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOffscreenSurface>
#include <QOpenGLContext>

#include <memory>

// OpenGL 3.3 core, where it is usable.

namespace app {

/// Whether OpenGL is worth trying: other platforms have none, or create a context that crashes
/// while drawing. False without a QGuiApplication.
bool platformHasGl();

QSurfaceFormat coreFormat();

/// A new context that is current on the surface; null on failure.
std::unique_ptr<QOpenGLContext> contextOn(QOffscreenSurface& surface);

/// The name of the current context's renderer: "llvmpipe", "Mesa Intel UHD".
QString rendererOf(QOpenGLContext& context);

/// Whether a renderer of this name draws on the processor.
bool isSoftware(const QString& renderer);

} // namespace app
