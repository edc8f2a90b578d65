// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/arc_curves.h"
#include "app/document/bezier.h"

#include <optional>

namespace app {

/// The ellipse of which a curve is a part of up to a quarter turn, if it is drawn as programs draw
/// such parts: in the middle and at the ends it is on the ellipse, elsewhere off by at most 0.03 %
/// of the radius. The curve may be off by 0.05 % in all. Straight curves, and those shorter than
/// 1/64 of a turn, have none.
std::optional<EllipseArc> ellipseOf(const Bezier& curve);

/// The angle of that point of an ellipse that is in the direction of another one, as seen from the
/// centre; from -π to π.
double angleTowards(const EllipseArc& ellipse, const Point& p);

/// The point of an ellipse in the direction of another one, as seen from its centre.
Point onEllipse(const EllipseArc& ellipse, const Point& p);

} // namespace app
