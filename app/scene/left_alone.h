// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/window_needs.h"

namespace app {

// A variant beside others is not replaced where it cannot clip (`usedAt`): it leaves those clip
// windows alone, and shows what it can.

/// The numbers of the steps at which the variant cannot clip, ascending. Empty if it can clip at
/// all, and if the others alone would give another result elsewhere: where such a window does not
/// add, or the outside is kept.
std::vector<std::size_t> leftAlone(const ClipRegion& region, const Variant& variant);

/// The windows, of which the visible ones with these numbers contain nothing.
ClipWindows without(ClipWindows windows, std::span<const std::size_t> steps);

} // namespace app
