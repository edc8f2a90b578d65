// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"
#include "app/recovery/replay.h"

namespace app {

/// Reads a leftover: replays a journal, with its history, or reads an SVG file, without one. On
/// any thread. An error is a sentence.
Result<Recovered> recover(const Leftover& leftover);

} // namespace app
