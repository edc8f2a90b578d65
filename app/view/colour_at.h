// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/picking.h"

namespace app {

/// The colour of what is seen at a point: of the nearest line within `radius`, else of the area
/// there. Empty: nothing is there. Lines of locked layers count, too.
std::optional<Colour> colourAt(const Document& document, const Scene& scene, const Picking& picking,
                               const Point& point, double radius);

} // namespace app
