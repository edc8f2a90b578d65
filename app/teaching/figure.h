// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/figure_colours.h"
#include "app/teaching/figure_frame.h"
#include "app/teaching/walk_step.h"

class QPainter;

// The picture of one step of a walk: for the microscope, for pages and for files.

namespace app {

/// Paints a step into frame.picture(): the window orange, the lines that its edges lie on with
/// their names, the edge of this step blue and hatched beyond, what is left of the line strong,
/// what is discarded dashed, ends as circles, cuts as diamonds with their coordinates, a cut that
/// is only weighed hollow. A step that the walk does not have: window and line alone. Nothing is
/// painted outside the picture but half a stroke, whatever the numbers are.
void paintStep(QPainter& painter, const WalkStep& at, const FigureFrame& frame,
               const FigureColours& colours);

} // namespace app
