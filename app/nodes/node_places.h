// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/nodes/node_path.h"

#include <functional>

namespace app {

/// Moves each selected node, with its handles, exactly to where `place` says. False, without a
/// change: a place is not finite.
bool placeSelected(NodePath& path, const std::function<Point(const Point& at)>& place);

/// After selected nodes have moved: keeps the handles of smooth nodes near them in line with their
/// straight segments.
void alignAroundSelected(NodeSubpath& subpath);

} // namespace app
