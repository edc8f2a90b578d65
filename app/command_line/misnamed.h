// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/command.h"

#include <optional>

namespace app {

/// Why the editor does not start, and what it ends with.
struct Refusal {
    QString sentence;
    Exit exit;
};

/// Nothing if the editor can open `argument`; else what is wrong with it: a file that is not there,
/// or a command that is mistyped, with the one that may have been meant.
std::optional<Refusal> misnamed(const QString& argument);

} // namespace app
