// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/document/tree_draft.h"

#include <functional>
#include <span>

namespace app {

/// Copies of the objects, one for each of `changes`, each on top of its original's container and
/// without its id. The copy of a chosen group is a group (TreeDraft). Empty: too many groups.
using RowChange = std::function<void(ObjectRow&)>;
std::optional<Rearranged> withCopies(const Document& document, const ObjectRanges& objects,
                                     ContainerId entered, std::span<const RowChange> changes);

/// Puts everything of another drawing on top of a container, without ids. Its groups stay groups,
/// its layers are dissolved. The image of a layer gets a locked layer of its own, at its place or,
/// if the container is a group, below all groups around it. Empty: too many layers or groups, or
/// nested too deeply.
std::optional<Rearranged> withDrawing(const Document& document, const Document& other,
                                      ContainerId into);

/// The offset for pasted copies: the first multiple of `step`, from one step on, at which no copy
/// lies on an object of the document with the same path. The search ends after a thousand steps
/// (coordinates may be so large that a step changes nothing).
Point copyOffset(const Document& document, const Objects& copies, const Point& step);

} // namespace app
