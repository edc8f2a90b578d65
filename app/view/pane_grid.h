// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>

#include <vector>

namespace app {

/// The height of a pane's heading, and what is between two panes: logical pixels.
constexpr int paneHeading = 28, paneGap = 1;

/// Where so many panes stand in an area: in rows, all of exactly the same size (then a point of the
/// drawing is at the same place in each), so that a drawing of that breadth to its height is as
/// large as can be. What does not divide makes gaps wider.
std::vector<QRect> paneCells(const QSize& area, int count, double breadth);

/// How many of so many panes have room: all of them, or else 4, 2 or 1.
int panesWithRoom(const QSize& area, int count, double breadth);

} // namespace app
