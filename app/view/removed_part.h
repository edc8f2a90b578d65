// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace app {

/// How the part removed by the clip windows is shown.
enum class RemovedPart : std::uint8_t { Ghosted, Hidden, Shown };

} // namespace app
