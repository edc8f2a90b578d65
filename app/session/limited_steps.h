// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

// Undoable steps for which a document may have no room. Then nothing changes, and the session says
// why (`Session::refused`).

namespace app {

/// Moves or resizes the clip window that tools move; creates one if there is none.
void placeClipWindow(Session& session, const clipping::Window& window);

/// Adds an empty layer above all others; returns whether there was room.
bool addLayer(Session& session, const QString& name);

} // namespace app
