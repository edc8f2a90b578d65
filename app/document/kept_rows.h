// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_tree.h"

#include <span>

namespace app {

/// The rows of a list after a change of the document: those of objects, groups and layers that are
/// still there, with the new numbers of objects. An object that was moved in the painting order is
/// lost, like one that was removed.
struct KeptRows {
    std::vector<std::size_t> lost{}; ///< ascending places in the list
    std::vector<TreeRow> rows{};     ///< the others
};

/// `splices` are those of the change, `containers` the tree after it. O(rows · log splices).
KeptRows keptRows(const std::vector<TreeRow>& rows, std::span<const Splice> splices,
                  const Containers& containers);

} // namespace app
