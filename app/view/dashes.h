// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>

#include <span>
#include <vector>

namespace app {

/// Cuts a polyline into its dashes (app/document/dash_parts.h); lengths are in the unit of the
/// points. The dashes are in order, each with at least two points. A solid line is one of them.
std::vector<std::vector<QPointF>> dashes(std::span<const QPointF> polyline,
                                         std::span<const double> pattern, double phase,
                                         double shortest);

} // namespace app
