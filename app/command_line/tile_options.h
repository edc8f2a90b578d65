// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/drawing_files.h"
#include "app/cut/cut.h"
#include "app/tiles/tiling.h"

namespace app {

/// --tiles, and the options that need it.
std::vector<Option> tileOptions();

/// How the options divide a drawing among sheets; empty without --tiles. Throws WrongUsage.
std::optional<TilePlan> tilePlanOf(const ParsedArguments& arguments, const Page& page);

/// Writes the sheets of a drawing that has been cut, and says which. The title on them is the name
/// of the input. Throws WrongUsage or Failure.
void writeTiles(const ParsedArguments& arguments, const TilePlan& plan, const Document& drawing,
                const CutOptions& options, const Output& output);

} // namespace app
