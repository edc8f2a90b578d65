// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/tree_draft.h"

namespace app {

// Changes of groups. `objects` are the chosen ones, `entered` the group that is entered, if any: it
// and groups around it are never chosen as a whole (TreeDraft). Empty: the document would have too
// many containers, or nest them too deeply.

/// Puts the objects into a new group, in the place and the container of the topmost of them.
std::optional<Rearranged> grouped(const Document& document, const ObjectRanges& objects,
                                  ContainerId entered);
/// Dissolves the groups that are chosen. Changes nothing if none is.
std::optional<Rearranged> ungrouped(const Document& document, const ObjectRanges& objects,
                                    ContainerId entered);

} // namespace app
