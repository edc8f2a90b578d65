// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/cut.h"
#include "app/document/scene.h"

namespace app {

/// How many segments of the frame leave something to be kept. For Keep::Outside the frame must hold
/// what was removed.
std::size_t visibleLines(const Frame& frame, Keep keep);

} // namespace app
