// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/page.h"
#include "app/formats/svg/report.h"
#include "app/formats/svg/tree.h"

#include <string>

// Guides as elements of the root's metadata, in order:
//   <clearcut:guide x="20"/> <clearcut:guide y="37.5"/>

namespace app::svg {

std::string textOf(const Guides& guides); ///< "" without guides

/// Reads the guides that Clearcut wrote into a file. Guides without one finite number, and those
/// beyond `Guides::most`, are dropped and reported.
Guides readGuides(const Tree& tree, Report& report);

} // namespace app::svg
