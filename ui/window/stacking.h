// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace ui {

/// How many panels of a stack, counted from below, must share the lowest place as tabs so that none
/// is smaller than it needs. `needed` are the heights of the panels from top to bottom, `room` is
/// the height of the column, in logical pixels. 0: all fit one below the other. Otherwise at least
/// 2, and the first panel always keeps a place of its own, even if the room is too small for that.
int lowerTabs(std::span<const int> needed, int room);

} // namespace ui
