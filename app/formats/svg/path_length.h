// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <span>

namespace app::svg {

/// The length of all paths together, of curves within 1e-9 of it.
double lengthOf(std::span<const Subpath> paths);

} // namespace app::svg
