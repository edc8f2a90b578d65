// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app {

/// Calls `visit` for every point of a path: its start, the end of each path segment, and the control
/// points of curves. The points of a path that is not const may be changed.
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
