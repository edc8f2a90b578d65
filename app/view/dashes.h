// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>

#include <span>
#include <vector>

namespace app {

/// Cuts a polyline into its dashes. `pattern` is dash, gap, dash, gap … (a pattern of odd length is
/// repeated, as in SVG); `phase` is the offset into the pattern at the start of the polyline. Both
/// are in the unit of the points. The dashes are in order, each with at least two points. The
/// result is the polyline itself if the pattern is empty, not positive or shorter than `shortest`.
std::vector<std::vector<QPointF>> dashes(std::span<const QPointF> polyline,
                                         std::span<const double> pattern, double phase,
                                         double shortest);

} // namespace app
