// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/snapping/snap_offers.h"

// The rows of the catalogue, each in the file of its name. For these files and the catalogue only.

namespace app {

SnapKind ends();
SnapKind middles();
SnapKind centres();
SnapKind intersections();
SnapKind perpendicular();
SnapKind onPath();
SnapKind windowEdges();
SnapKind pageEdges();
SnapKind axes();
SnapKind guideKind();
SnapKind gridKind();
SnapKind alignmentKind();
SnapKind drawnAlignment();

} // namespace app
