// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

#include <QString>

namespace app {

/// The direction in which y grows on screen: down in drawings, up in lessons and figures. The
/// library's Top is the edge at ymax in either case.
enum class YAxis : std::uint8_t { Down, Up };

/// The edge as it is seen on screen with y up, as an index: 0 none, 1 left, 2 right, 3 bottom, 4
/// top.
constexpr std::size_t seenEdge(clipping::Edge edge, YAxis y)
{
    const auto at = static_cast<std::size_t>(edge);
    return y == YAxis::Down && at >= 3 ? 7 - at : at;
}

/// "the top edge", as seen on screen; empty for Edge::NoEdge.
QString edgeWords(clipping::Edge edge, YAxis y);

} // namespace app
