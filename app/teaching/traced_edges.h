// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/traced_line.h"

namespace app {

/// The edges of the window of a traced line, rectangle or polygon, one after the other.
std::vector<clipping::Segment> edgesOf(const TracedLine& tracedLine);

} // namespace app
