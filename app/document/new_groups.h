// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/containers.h"

namespace app {

/// A group to be made around consecutive objects, which lie directly in one container and have no
/// other container between them.
struct NewGroup {
    ObjectRange objects;
    Container group; ///< its id is ignored
};

/// The tree with these groups, whose objects ascend. Empty if there would be too many containers,
/// or more around an object than `Containers::deepest`. O(containers + groups).
std::optional<Containers> withGroups(const Containers& tree, std::span<const NewGroup> groups);

} // namespace app
