// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/nodes/node_path.h"

namespace app {

/// What an edit that moves nodes and handles leaves where it is: segments, each as a subpath, and
/// single nodes between segments that change.
std::vector<Subpath> fixedParts(const NodeSubpath& before, const NodeSubpath& after);

} // namespace app
