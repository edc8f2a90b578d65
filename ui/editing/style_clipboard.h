// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

namespace ui {

// A copied style is kept apart from the system's clipboard, so that copied objects stay there. Like
// the clipboard it belongs to the program: it may be pasted into another drawing.

void copyStyle(const app::Session& session);
bool hasCopiedStyle();
/// Does nothing without a copied style.
void pasteStyle(app::Session& session);

} // namespace ui
