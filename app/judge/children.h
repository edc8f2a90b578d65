// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <sys/types.h>
#include <vector>

namespace app::plug_in {

/// The children of this process, which must have a single thread, including ended children that
/// were not waited for. While processes start and end some may be missing: call it again.
std::vector<pid_t> ownChildren();

/// The same from the kernel's list; empty if there is no such list (a kernel without
/// CONFIG_PROC_CHILDREN).
std::optional<std::vector<pid_t>> listedChildren();

/// The same from the parent of every process in /proc, which takes longer.
std::vector<pid_t> scannedChildren();

} // namespace app::plug_in
