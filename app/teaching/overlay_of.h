// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/overlays/overlay.h"

namespace app {

/// Computed anew at each call, in the time of a few traces. Numbers that nothing can be done with
/// (not finite, a window turned inside out) give a caption that says so.
Overlay overlayOf(const OverlaySubject& subject);

} // namespace app
