// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/page.h"
#include "app/formats/svg/report.h"
#include "app/formats/svg/tree.h"

#include <optional>
#include <string>

// How the page is divided among sheets of paper, as an element of the root's metadata:
//   <clearcut:sheets paper="A4 landscape" margin="10" overlap="10" scale="1" shift="3 0"
//     marks="registration labels crop" left-out="2 6"
//     beyond="1 0 0 0"/>
// `beyond` are the sheets left of, above, right of and below the page that the numbers of left-out
// count. By number, columns="3" rows="2" are in place of the shift. Sheets without any part of the
// drawing are left out unless empty="written".

namespace app::svg {

std::string textOf(const std::optional<PageSheets>& sheets); ///< "" without sheets

/// Reads what Clearcut wrote into a file: the last such element. One with a missing or invalid
/// number is dropped and reported.
std::optional<PageSheets> readSheets(const Tree& tree, Report& report);

} // namespace app::svg
