// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/nodes/node_path.h"

namespace app {

/// The segments that an edit does not move, each as a subpath, and the nodes that it does not move
/// although both their segments change.
std::vector<Subpath> fixedParts(const NodeSubpath& before, const NodeSubpath& after);

} // namespace app
