// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

namespace app {

/// The drawing with its curves replaced by lines, no farther than `tolerance` (user units, > 0)
/// from them. Objects without curves are shared.
Document flattened(Document document, double tolerance);

} // namespace app
