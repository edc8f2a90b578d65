// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>

namespace ui {

enum class Backend : std::uint8_t { Automatic, OpenGL, Raster };

/// The result of testing OpenGL on this computer.
struct GlProbe {
    bool usable = false;   ///< a 3.3 core context can be made and shown
    bool software = false; ///< rendered by the CPU (llvmpipe, softpipe)
    QString renderer;
};
GlProbe probeGl();

/// The canvas to use, and a sentence that gives the reason.
struct Choice {
    Backend backend;
    QString reason;
};
Choice chooseBackend(Backend wish, const GlProbe& probe);

} // namespace ui
