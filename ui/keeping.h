// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/session.h"

namespace ui {

/// Chooses the side of the clip windows that is kept, as a step to undo; none if it is kept already.
void setKeep(app::Session& session, app::Keep keep);

} // namespace ui
