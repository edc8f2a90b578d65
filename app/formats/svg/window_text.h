// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"
#include "app/formats/svg/report.h"
#include "app/formats/svg/tree.h"

#include <string>

// Clip windows as elements of the root's metadata, in their order. What is usual is not said:
//   <clearcut:window xmin="0" ymin="0" xmax="9" ymax="9"/>
//   <clearcut:window name="Hole" operation="cut-out" visible="no" xmin=… angle="0.5rad"/>
//   <clearcut:window operation="intersect" corners="0 0 9 0 9 9"/>
// The first one says keep="outside" of all; without a window, one that has no shape does.

namespace app::svg {

/// "" if there is nothing to say.
std::string textOf(const ClipWindows& windows);

/// Those that Clearcut wrote into a file. What is left out is reported: windows that are inverted,
/// have a missing or invalid number or an unknown operation, and those above `ClipWindows::most`. So is
/// an unknown value of keep or visible, which counts as the usual one.
ClipWindows readWindows(const Tree& tree, Report& report);

} // namespace app::svg
