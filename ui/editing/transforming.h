// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

namespace ui {

/// A transformation of the selection about its middle.
enum class Turn : std::uint8_t { Left, Right, FlipAcross, FlipDown };

/// One undo step; does nothing without a selection.
void turnSelection(app::Session& session, Turn turn);

} // namespace ui
