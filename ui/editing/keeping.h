// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

// Undoable steps that several places of the interface offer. No step is pushed if nothing would
// change.

namespace ui {

/// Chooses the side of the clip windows that is kept.
void setKeep(app::Session& session, app::Keep keep);

void keepOtherSide(app::Session& session);

/// Lays a clip window on the page (app/session/window_places.h).
void layWindowOnPage(app::Session& session);

} // namespace ui
