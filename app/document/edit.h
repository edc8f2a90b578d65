// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"
#include "app/document/containers.h"
#include "app/document/number_runs.h"
#include "app/document/objects.h"
#include "app/document/page.h"

#include <optional>
#include <span>
#include <vector>

namespace app {

/// One change of a document, as a value: `splices` replace objects, and every optional member that
/// is set replaces its part of the document. The history stores edits, not documents.
struct Edit {
    std::vector<Splice> splices{}; ///< ascending, not overlapping, in the old numbering
    Objects objects{};             ///< all added objects, in the order of the splices
    /// The new container tree, which covers the new number of objects. Required if the number of
    /// objects or their containers change.
    std::optional<Containers> containers{};
    std::optional<ClipWindows> windows{};
    std::optional<Page> page{};
    /// Where the added objects were, in the old numbering; `none` for those that are new. Empty:
    /// objects that are replaced one for one are the same ones, changed; so is the first of several
    /// that replace one.
    NumberRuns moved{};
    /// The numbers in the names of the added objects (object_numbers.h); empty: not known. Only
    /// EditedDocument sets them, in the edits that it returns.
    NumberRuns numbers{};

    /// The heap bytes that the history uses for this edit: the bytes that this edit keeps alive and
    /// `opposite` does not. `opposite` is the edit whose application to the document returned this
    /// one. Memory shared by several edits of a history thus counts only once: for the edit whose
    /// opposite removed it from the document.
    std::size_t bytesNotIn(const Edit& opposite) const;
};

/// The splices that undo `splices`, in the numbering after them.
std::vector<Splice> inverse(std::span<const Splice> splices);

/// The objects that `splices` added, in the numbering after them.
ObjectRanges addedBy(std::span<const Splice> splices);

} // namespace app
