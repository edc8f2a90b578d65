// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/figure_frame.h"
#include "app/teaching/step_scene.h"

class QPainter;

// The picture of one step of a trace: for the microscope, for pages and for files.

namespace app {

/// Paints a step into frame.picture(): the window orange, the infinite lines of its edges with
/// their names, the edge of this step blue with another ground beyond it, edges outside the picture
/// at its rim with break marks (figure_edges.h), the remaining part of the line strong, discarded
/// parts dashed, ends as circles, cuts as diamonds with their coordinates, candidate cuts hollow.
/// For a step that the trace does not have: only window and line. Nothing is painted outside the
/// picture by more than half a stroke, whatever the numbers are.
void paintStep(QPainter& painter, const TraceStep& at, const FigureFrame& frame,
               const FigureColours& colours);

} // namespace app
