// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/nodes/node_path.h"

namespace app {

/// Removes the selected nodes. Between the nodes that stay, one segment keeps the shape as well as
/// it can: a line in place of lines, otherwise the best curve (curve_fit.h). A subpath without
/// segments left is removed. Whether any node was selected.
bool deleteSelected(NodePath& path);

} // namespace app
