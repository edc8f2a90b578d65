// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/arc_curves.h"

#include <optional>
#include <vector>

namespace app::dxf::writing {

/// The part of one ellipse, or all of it, that a path of curves is; empty: it is none. It begins
/// and ends where the path does; axes of equal length at right angles are a circle's.
std::optional<EllipseArc> singleArcOf(const Subpath& path);
bool isCircle(const EllipseArc& arc);

/// For each segment of a path the tangent of a quarter of its angle, > 0 if it turns from x to y,
/// if it is part of a circle; 0 for lines; empty for other curves.
std::vector<std::optional<double>> bulgesOf(const Subpath& path);

} // namespace app::dxf::writing
