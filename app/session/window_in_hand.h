// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/window_needs.h"
#include "app/session/session.h"

namespace app {

// The clip window that panels act on, as far as algorithms are concerned.

/// The window among the region's steps; null without a visible window.
const ClipRegion::Step* stepInHand(const Session& session);
/// What it demands of an algorithm; a rectangle if there is none, since then nothing is cut.
WindowNeeds needsInHand(const Session& session);
/// "for Star: concave, 10 edges", "for a window: rectangle"; empty without a window.
QString headingInHand(const Session& session);

/// The variant that clips the drawing, whatever is chosen.
Variant usedVariant(const Session& session);

} // namespace app
