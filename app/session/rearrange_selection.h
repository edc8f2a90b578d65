// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/stacking.h"
#include "app/session/session.h"

namespace app {

// Steps that change the order of the selected objects, and the groups and layers they are in. Each
// is one undo step; the objects stay selected. What changes nothing, or cannot be done, is refused
// by Session::refused.

void groupSelection(Session& session);
void ungroupSelection(Session& session);
void stackSelection(Session& session, Stacking how);
/// To the top of the layer.
void moveSelectionTo(Session& session, ContainerId layer);
/// Into the layer or group, above what ends at or below the object `at` there.
void moveSelectionBetween(Session& session, ContainerId into, std::size_t at);
/// To the next layer above (1) or below (-1); layers that are hidden or locked are passed over.
void moveSelectionBy(Session& session, int layers);
/// The names and ids of layers to which the selection can be moved, from top to bottom.
std::vector<ContainerId> usableLayers(const Session& session);

} // namespace app
