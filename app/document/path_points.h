// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app {

/// Calls `visit` for every point of a path: its start, the end of each path segment, and the
/// control points of curves. `visit` may change the points if the path is not const.
template <class SomePath, class Visit>
void forEachPoint(SomePath& path, const Visit& visit)
{
    visit(path.start);
    for (auto& segment : path.segments) {
        visit(segment.to);
        if (segment.curved) {
            visit(segment.control1);
            visit(segment.control2);
        }
    }
}

} // namespace app
