// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/copy_selection.h"

namespace ui {

// The Edit menu's functions on the selection and the clipboard (SVG). Each is one undo step.

void copySelection(const app::Session& session);
void cutSelection(app::Session& session);
/// Whether the clipboard held a drawing; if not, `nothingToPaste()` says so.
bool paste(app::Session& session, app::PastePlace place);
QString nothingToPaste();
void deleteSelection(app::Session& session);
/// Selects every object that is visible and not locked, in the entered group if there is one.
void selectAll(app::Session& session);

} // namespace ui
