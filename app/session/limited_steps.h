// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

// Undoable steps that fail if the document already has as many clip windows or layers as it may
// have. Then nothing changes, and `Session::refused` says why.

namespace app {

/// Moves or resizes the clip window that tools move; creates one if there is none.
void placeClipWindow(Session& session, const clipping::Window& window);

/// Adds an empty layer above all others; returns whether there was room.
bool addLayer(Session& session, const QString& name);

} // namespace app
