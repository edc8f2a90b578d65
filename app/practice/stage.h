// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/stage_answers.h"
#include "app/practice/practice.h"

// Where a move is answered in the figure.

namespace app {

/// The edges of the window, if an edge is to be picked or was picked, in the order of the digits.
/// While the move is open they say nothing about which one is right.
std::vector<StageAnswer> edgesToPick(const Practice& practice, const FigureFrame& frame);

/// Whether the student places a cut.
bool isPlacing(const Practice& practice);
/// The place along the line, 0 at End 1 and 1 at End 2, that a place in the picture means; empty if
/// it is not near the line.
std::optional<double> placeNear(const QPointF& place, const Practice& practice,
                                const FigureFrame& frame);
/// Where the mark of the cut is in the picture: where it is set, or once the move is settled, where
/// it belongs. Empty if the move is another.
std::optional<QPointF> markOf(const Practice& practice, const FigureFrame& frame);

} // namespace app
