// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>

#include <vector>

namespace app {

/// The height of a pane's heading, and the gap between panes, in logical pixels.
constexpr int paneHeading = 28, paneGap = 1;

/// The positions of `count` panes in an area: in rows, all of exactly the same size, so that a
/// point of the drawing has the same place in each, and a drawing of aspect ratio `breadth` (width
/// ÷ height) is as large as possible. Remaining pixels widen the gaps.
std::vector<QRect> paneCells(const QSize& area, int count, double breadth);

/// The number of panes for which there is room: `count`, or else 4, 2 or 1.
int panesWithRoom(const QSize& area, int count, double breadth);

} // namespace app
