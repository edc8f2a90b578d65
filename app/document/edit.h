// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"
#include "app/document/containers.h"
#include "app/document/objects.h"
#include "app/document/page.h"

#include <optional>
#include <span>
#include <vector>

namespace app {

/// What one step changes in a document, as a value: objects are exchanged in places, and what else
/// is given takes the place of what was there. The history keeps edits, not documents.
struct Edit {
    std::vector<Splice> splices{}; ///< ascending, not overlapping, numbered as before the edit
    Objects objects{};             ///< all that are added, one after the other
    /// The tree afterwards, of as many objects as there are then; needed where their number or
    /// their containers change.
    std::optional<Containers> containers{};
    std::optional<ClipWindows> windows{};
    std::optional<Page> page{};

    /// Bytes of the heap that the history holds with this edit: those that it keeps alive and
    /// `opposite` does not, which the document has just applied to give this one. So what many
    /// edits of a history share counts once: for the one whose opposite took it from the document.
    std::size_t bytesNotIn(const Edit& opposite) const;
};

/// The splices that put back what those exchanged, numbered as after them.
std::vector<Splice> inverse(std::span<const Splice> splices);

/// The objects that those have added, as they are numbered afterwards.
ObjectRanges addedBy(std::span<const Splice> splices);

} // namespace app
