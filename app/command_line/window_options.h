// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/given.h"

namespace app {

/// The options of every command that looks at a drawing through a clip window: --window, --page and
/// --margin.
std::vector<Option> windowOptions();

/// What they say: by itself the drawing's own. Throws WrongUsage, also for an empty window.
clipping::Window windowOf(const Given& given, const Sheet& sheet);

} // namespace app
