// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

namespace app {

// Each is one undo step, and selects the copies.

/// Copies of the selected objects in the same place, each on top of its original's layer or group.
/// The copy of a group is a group.
void duplicateInPlace(Session& session);

/// Where a pasted drawing lies: where it was copied, or at the next free offset from there, so that
/// repeated copies do not lie on each other.
enum class PastePlace : std::uint8_t { Offset, InPlace };
/// Adds everything of a drawing on top of the entered group or the current layer. If that is locked
/// or hidden, nothing changes, and `Session::refused` says so. With an offset it comes into the
/// middle of `seen` if it would lie outside. An image below objects stays out if the session's
/// drawing shows the same one where it was copied.
void paste(Session& session, const Document& drawing, PastePlace place,
           const std::optional<clipping::Window>& seen = {});

} // namespace app
