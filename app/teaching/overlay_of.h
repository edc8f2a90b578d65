// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/overlays/overlay.h"

namespace app {

/// Computes the overlay again at each call, in the time of a few traces. For invalid numbers (not
/// finite, or an inverted window) the overlay has only a caption that says so.
Overlay overlayOf(const OverlaySubject& subject);

} // namespace app
