// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/parsed_arguments.h"
#include "app/scene/region.h"

namespace app {

/// The options of every command that clips a drawing at a window: --window, --page and --margin.
std::vector<Option> windowOptions();

/// The same for windows of any shape, of which there may be several
/// (app/command_line/window_forms.h).
std::vector<Option> shapedWindowOptions();

/// The options of a command that compares algorithms at one window, a rectangle or a polygon.
std::vector<Option> comparedWindowOptions();

/// The drawing's own window: the first visible clip window that is an axis-aligned rectangle;
/// otherwise the page, or, in a file without a page, the bounds of everything drawn.
clipping::Window windowOf(const Imported& imported);

/// The clip window given by the options; otherwise the drawing's own: always one window, which
/// adds. Throws WrongUsage for several.
ClipWindows comparedWindowsOf(const ParsedArguments& arguments, const Imported& imported);

/// All clip windows given by the options, in the order in which they were given; otherwise the
/// drawing's visible ones, with the side that it keeps, or else the result of `windowOf`. Always
/// contains a window that clips.
ClipWindows windowsOf(const ParsedArguments& arguments, const Imported& imported);

/// Whether the options alone say where to clip, without the drawing: some windows are given, and
/// none of them is the page or a shape of the drawing.
bool windowsNeedNoDrawing(const ParsedArguments& arguments);

/// "Window (the page): -40,-40,40,40 in …": the source of `windowsOf`, and each window as
/// `placeText`. If the windows are not simply added: "Windows (saved in the drawing): add …; cut
/// out …". Mentions if the outside is kept.
QString windowText(const ParsedArguments& arguments, const Imported& imported,
                   const ClipRegion& region);

/// "10mm,10mm,90mm,90mm from the paper's top left corner", rounded to micrometres.
QString millimetreText(const clipping::Window& rectangle, const Imported& imported);

/// "-40,-40,40,40 in the drawing's coordinates, 10mm,…" with `millimetreText`, which is omitted if
/// its numbers are the same.
QString placeText(const clipping::Window& rectangle, const Imported& imported);

} // namespace app
