// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

namespace app {

/// The default algorithm: the one whose results are always exact.
inline const clipping::Algorithm& usualAlgorithm() { return clipping::exactAlgorithm(); }

} // namespace app
