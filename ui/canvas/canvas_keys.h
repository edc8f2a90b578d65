// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/controller.h"

// The keys that work while the canvas has the focus.

namespace ui {

/// Whether the canvas has a use for the key before the shortcut of a command.
bool takesKey(const QKeyEvent& event, const Controller& controller);
/// True: consumed.
bool pressKey(QKeyEvent& event, Controller& controller);
bool releaseKey(const QKeyEvent& event, Controller& controller);

} // namespace ui
