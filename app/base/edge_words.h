// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

#include <QString>

namespace app {

/// The direction in which y grows on screen: down in drawings, up in lessons and figures. The
/// library's Top is the edge at ymax in either case.
enum class YAxis : std::uint8_t { Down, Up };

/// "the top edge", as seen on screen; empty for Edge::NoEdge.
QString edgeWords(clipping::Edge edge, YAxis y);

} // namespace app
