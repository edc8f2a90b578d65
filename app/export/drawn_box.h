// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

namespace app {

/// The box around all that is seen of a drawing: lines with their width, the tips of their joins
/// and their caps, and filled areas. Empty if nothing is seen.
std::optional<clipping::Window> drawnBox(const Document& document);

} // namespace app
