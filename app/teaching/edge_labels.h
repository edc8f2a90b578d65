// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/figure_labels.h"

namespace app {

/// The lines that are drawn for the edges of a window: the infinite lines of a rectangle's edges,
/// the sides of a polygon.
std::vector<QLineF> drawnEdges(const TracedLine& tracedLine, const FigureFrame& frame);

/// Labels the edges and the window itself: their values, how far edges at the rim are, or the
/// numbers of a polygon's sides.
void labelEdges(std::vector<FigureLabel>& labels, const TracedLine& tracedLine,
                const StepScene& scene, LabelObstacles& obstacles, const FigureFrame& frame);

} // namespace app
