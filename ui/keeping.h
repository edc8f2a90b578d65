// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

// Steps to undo that several places of the interface offer. None is made where nothing would
// change.

namespace ui {

/// Chooses the side of the clip windows that is kept.
void setKeep(app::Session& session, app::Keep keep);

/// Lays the clip window on the page; a new one if there is none.
void layWindowOnPage(app::Session& session);

} // namespace ui
