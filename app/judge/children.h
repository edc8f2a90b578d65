// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <sys/types.h>
#include <vector>

namespace app::plug_in {

/// The children of this process, which must have one thread, with those that have ended and were
/// not waited for. While processes start and end some can be missing: ask again.
std::vector<pid_t> ownChildren();

/// The same as the system lists them; nothing where it keeps no such list (a kernel without
/// CONFIG_PROC_CHILDREN).
std::optional<std::vector<pid_t>> listedChildren();

/// The same by the parent of every process in /proc, which takes longer.
std::vector<pid_t> scannedChildren();

} // namespace app::plug_in
