// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/figure_frame.h"
#include "app/teaching/narration.h"

namespace app {

/// A place in a corner of a figure, for what lies over it.
struct CornerPlace {
    Qt::Corner corner;
    QRectF box;
    int covered; ///< how much it hides: an end 8, the line 4, an edge or a break mark 1
};

/// From this on a place hides the line or its marks.
constexpr int hidesLine = 4;

/// The place of a box of this size in a corner, inside the edges at the rim if it hides less there.
/// Counts the marks of all steps, so that it stays from step to step.
CornerPlace placeIn(Qt::Corner corner, const QSizeF& box, const TracedLine& tracedLine,
                    const Narration& narration, const FigureFrame& frame);

/// The one of the four places that hides least; of several the first of top left, top right, bottom
/// right, bottom left.
CornerPlace quietCorner(const QSizeF& box, const TracedLine& tracedLine, const Narration& narration,
                        const FigureFrame& frame);

} // namespace app
