// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/canvas.h"

namespace ui {

/// What is known of OpenGL here.
struct GlProbe {
    bool usable = false;   ///< a 3.3 core context can be made and shown
    bool software = false; ///< it is drawn by the processor (llvmpipe, softpipe)
    QString renderer;
};
GlProbe probeGl();

/// The canvas to use, and a sentence why.
struct Choice {
    Backend backend;
    QString reason;
};
Choice chooseBackend(Backend wish, const GlProbe& probe);

} // namespace ui
