// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/command.h"

#include <optional>

namespace app {

/// Why the editor does not start, and its exit code.
struct Refusal {
    QString sentence;
    Exit exit;
};

/// Empty if the editor can open `argument`; otherwise what is wrong: a missing file, or a mistyped
/// command with a suggestion.
std::optional<Refusal> misnamed(const QString& argument);

} // namespace app
