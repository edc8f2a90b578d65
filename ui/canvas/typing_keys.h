// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/controller.h"

// The keys that type numbers: a field of the readout opens with the first one.

namespace ui {

bool beginsTyping(const QKeyEvent& event, const Controller& controller);
void beginTyping(const QKeyEvent& event, Controller& controller);
/// A number typed during a gesture that takes none does nothing: it must not choose the algorithm.
bool keepsFromShortcuts(const QKeyEvent& event, const Controller& controller);

} // namespace ui
