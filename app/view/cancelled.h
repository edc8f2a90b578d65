// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace app {

/// Long computations call this frequently; true: stop, the result is no longer needed.
using Cancelled = std::function<bool()>;
inline bool neverCancelled() { return false; }

} // namespace app
