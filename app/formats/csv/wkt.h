// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <string_view>
#include <vector>

namespace app::csv {

/// Whether a field begins as the WKT (well-known text) of lines does.
bool isWkt(std::string_view field);

/// The lines of a LINESTRING or MULTILINESTRING, without z and m; none: it is empty. Throws Refused
/// for anything else.
std::vector<Subpath> linesOfWkt(std::string_view text, std::size_t line);

} // namespace app::csv
