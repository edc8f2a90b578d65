// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/recipe.h"
#include "app/document/window_frame.h"
#include "app/session/session.h"

namespace app {

/// The recipe of the only selected object; of any other selection none.
Recipe onlyRecipe(const Session& session);

/// The rectangle that the handles of the selection stand on and whose sides are its width and
/// height: its bounds, but a turned rectangle or ellipse has one that is turned with it.
std::optional<WindowFrame> selectionFrame(const Session& session);

} // namespace app
