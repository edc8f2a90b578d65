// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"
#include "app/formats/svg/report.h"
#include "app/formats/svg/tree.h"

#include <string>

// Clip windows as elements of the root's metadata, in order. Default values are not written:
//   <clearcut:window xmin="0" ymin="0" xmax="9" ymax="9"/>
//   <clearcut:window name="Hole" operation="cut-out" visible="no" colour="#c2410c" xmin=…/>
//   <clearcut:window operation="intersect" d="M0 0L9 0L9 9Z"/>
// The first element carries keep="outside" for all windows; without windows, an element without a
// shape carries it.

namespace app::svg {

/// "" if everything has its default value.
std::string textOf(const ClipWindows& windows);

/// Reads the windows that Clearcut wrote into a file. Windows are dropped and reported if they are
/// inverted, have a missing or invalid number or an unknown operation, or exceed
/// `ClipWindows::most`. An unknown value of keep, visible or colour is reported and replaced by the
/// default.
ClipWindows readWindows(const Tree& tree, Report& report);

} // namespace app::svg
