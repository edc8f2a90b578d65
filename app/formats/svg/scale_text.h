// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/page.h"
#include "app/formats/svg/report.h"
#include "app/formats/svg/tree.h"

#include <string>

// The drawing's scale, the page's margins and its background as an element of the root's metadata.
// Usual values are not written:
//   <clearcut:page scale="50" unit="m" margins="20 10 10 10" show-margins="yes"
//                  background="#f4ecd8" export-background="yes"/>
// The margins are in millimetres on paper: left, top, right, bottom.

namespace app::svg {

/// "" if everything is as usual.
std::string scaleTextOf(const Page& page);

/// Reads what Clearcut wrote into a file. A scale, a unit, margins or a background that it could
/// not have written are reported, and are as usual.
void readScale(const Tree& tree, Page& page, Report& report);

} // namespace app::svg
