// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/undo_command.h"

#include <span>

namespace app {

/// All kinds of commands. A test creates a command for each key and fails for an unknown one, so
/// every new command is tested together with all others.
std::span<const CommandKind> commandKinds();

} // namespace app
