// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/undo_command.h"

#include <span>

namespace app {

/// Every kind of command that there is. A test draws commands from this list by key, and fails
/// where it cannot make one, so a new command is tested together with all others.
std::span<const CommandKind> commandKinds();

} // namespace app
