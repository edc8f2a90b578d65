// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/given.h"

namespace app {

/// The options of every command that looks at a drawing through a clip window: --window, --page and
/// --margin.
std::vector<Option> windowOptions();

/// What they say, in user units: by itself the drawing's own. Bare numbers count from the user
/// origin, lengths with a unit from the paper's top left corner (of a file without a page, from the
/// user origin, too). Throws WrongUsage, also for an empty window.
clipping::Window windowOf(const Given& given, const Imported& imported);

/// Whether --window has a length with a unit, so that it is worth saying where that is.
bool windowHasUnits(const Given& given);

/// "10mm,10mm,90mm,90mm from the paper's top left corner", rounded to micrometres.
QString millimetreText(const clipping::Window& rectangle, const Imported& imported);

/// "-40,-40,40,40 in the drawing's coordinates, 10mm,…" as `millimetreText`.
QString placeText(const clipping::Window& rectangle, const Imported& imported);

} // namespace app
