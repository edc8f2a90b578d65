// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

#include <QString>

namespace app {

/// Where y grows to as it is seen: down in drawings, up in lessons and figures. The library's Top
/// is the edge at ymax in either case.
enum class YAxis : std::uint8_t { Down, Up };

/// "the top edge", as it is seen; empty for no edge.
QString edgeWords(clipping::Edge edge, YAxis y);

} // namespace app
