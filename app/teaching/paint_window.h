// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/figure_frame.h"
#include "app/teaching/step_scene.h"

class QPainter;

namespace app {

/// The painter of a figure, and everything that its parts are painted from.
struct FigurePainting {
    QPainter& painter;
    const TracedLine& tracedLine;
    const StepScene& scene;
    const FigureFrame& frame;
    const FigureColours& colours;
};

/// Fills what the edge of the step cuts off with a ground of its own.
void paintGround(const FigurePainting& with);
/// Paints the window, the infinite lines of its edges, the edge of the step, and the break marks of
/// edges at the rim (figure_edges.h).
void paintWindow(const FigurePainting& with);

} // namespace app
