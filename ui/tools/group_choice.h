// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/units.h"
#include "ui/tools/tool.h"

// What a click selects: an object, or the group that it is in.

namespace ui {

/// Selects what was clicked, or nothing. With Shift it is added to the selection, or taken out of
/// it; with Alt the object alone is meant, not its group. A click outside the entered group leaves
/// it. Returns whether the object is selected now.
bool choose(std::optional<std::size_t> object, Qt::KeyboardModifiers modifiers,
            app::Session& session);

/// Says that only locked objects are under the pointer, if so.
void refuseLocked(const Pointer& pointer, const Workbench& bench);

/// Enters the group of the object, and selects what is there. False: it is in no group that can be
/// entered.
bool enterGroupAt(app::Session& session, std::size_t object);

/// What a double click does to an object that is no path: enters its group, or selects and edits
/// the text. False: it is a path.
bool openAt(std::size_t object, Workbench& bench);
/// Leaves the entered group, and selects it.
void leaveGroup(app::Session& session);

} // namespace ui
