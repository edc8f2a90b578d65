// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>

#include <span>
#include <vector>

namespace app {

/// A polyline cut into its dashes. `pattern` is dash, gap, dash, gap … (an odd one is taken twice,
/// as in SVG), `phase` where in the pattern the polyline starts; both in the points' unit. The
/// dashes come one after the other; each has at least two points. A pattern that is empty, not
/// positive or shorter than `shortest` gives the polyline itself.
std::vector<std::vector<QPointF>> dashes(std::span<const QPointF> polyline,
                                         std::span<const double> pattern, double phase,
                                         double shortest);

} // namespace app
