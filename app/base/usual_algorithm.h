// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

namespace app {

/// The algorithm that clips unless another is chosen: the row that is never wrong.
inline const clipping::Algorithm& usualAlgorithm() { return clipping::exactAlgorithm(); }

} // namespace app
