// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/figure_frame.h"

namespace app {

/// The part of the drawing in which a line is large: in the middle, 58 % of the picture's width or
/// 60 % of its height, whichever comes first. Empty for a point and for a line that is not finite
/// or too short for its coordinates.
std::optional<clipping::Window> magnifying(const clipping::Segment& line, const QSizeF& picture);

/// With a scale bar: figureFrame() if the line is of a good size in it. Otherwise the line is
/// magnified, with a wrong result that lies beside it; the edges that are far away then are drawn
/// nearer (figure_edges.h).
FigureFrame nearFrame(const TracedLine& tracedLine, const QSizeF& size, const QFont& font);

} // namespace app
