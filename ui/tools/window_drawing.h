// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/window_kinds.h"
#include "ui/tools/tool.h"

namespace ui {

/// Draws a clip window with the session's window pen, as other tools draw objects: from one point
/// to another, or corner by corner. The session's preview holds the window so far.
std::unique_ptr<Tool> makeWindowDrawing(const app::WindowKind& kind);
/// Whether numbers typed now would change the window that it has drawn, from one point to another.
bool canCorrect(const Tool& drawing, const Workbench& bench);

} // namespace ui
