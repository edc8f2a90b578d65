// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene_frame.h"

namespace app {

/// Whether two frames of the same lines keep the same parts: as many pieces of each line, with ends
/// at most `tolerance` (user units, ≥ 0) apart on each axis, in either direction. Pieces that are
/// not longer than this count as none.
bool areSame(const SceneFrame& a, const SceneFrame& b, double tolerance);

} // namespace app
