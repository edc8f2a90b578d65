// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/edit_command.h"
#include "app/session/session.h"

namespace app {

/// A number of the clip window that tools act on; fields show and set it.
enum class WindowValue : std::uint8_t { X, Y, Width, Height, Angle };

/// Lengths in user units, those of the place from the origin of the display's unit; the angle in
/// degrees, counterclockwise, never −0. All are of the window's frame, also during a gesture;
/// without a window, of `Session::window`.
double windowValue(const Session& session, WindowValue which);

/// Sets it in one undo step; does nothing without a window. `keepsRatio`: the other side follows
/// the width or the height.
void setWindowValue(Session& session, WindowValue which, double number, bool keepsRatio,
                    Merging merging);

} // namespace app
