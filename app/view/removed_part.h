// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace app {

/// How what the clip windows take away is shown.
enum class RemovedPart : std::uint8_t { Ghosted, Hidden, Shown };

} // namespace app
