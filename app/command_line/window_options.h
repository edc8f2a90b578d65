// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/given.h"
#include "app/scene/region.h"

namespace app {

/// The options of every command that looks at a drawing through a clip window: --window, --page and
/// --margin.
std::vector<Option> windowOptions();

/// The drawing's own: the first axis-aligned rectangle of its clip windows that is visible; without
/// one the page, and in a file without a page all that is drawn.
clipping::Window windowOf(const Imported& imported);

/// The clip window that the options choose, in user units; without them the drawing's own. Bare
/// numbers count from the user origin, lengths with a unit from the paper's top left corner (in a
/// file without a page: from the user origin). Throws WrongUsage for a window that mixes the two,
/// and for an inverted one.
clipping::Window windowOf(const Given& given, const Imported& imported);

/// All clip windows that the options choose; without them the visible ones of the drawing, with the
/// side that it keeps, or else what `windowOf` gives. Never without a window that clips.
ClipWindows windowsOf(const Given& given, const Imported& imported);

/// "Window (the page): -40,-40,40,40 in …": where `windowsOf` took them from, and each as
/// `placeText`. Where they do not simply add up to one: "Windows (saved in the drawing): add …; cut
/// out …". Says so if the outside is kept.
QString windowText(const Given& given, const Imported& imported, const ClipRegion& region);

/// "10mm,10mm,90mm,90mm from the paper's top left corner", rounded to micrometres.
QString millimetreText(const clipping::Window& rectangle, const Imported& imported);

/// "-40,-40,40,40 in the drawing's coordinates, 10mm,…" with `millimetreText`, which is left out
/// where its numbers are the same.
QString placeText(const clipping::Window& rectangle, const Imported& imported);

} // namespace app
