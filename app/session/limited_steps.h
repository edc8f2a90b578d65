// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

// Undoable steps that fail if the document already has as many layers as it may have. Then nothing
// changes, and `Session::refused` says why.

namespace app {

/// Adds an empty layer above all others; returns whether there was room.
bool addLayer(Session& session, const QString& name);

} // namespace app
