// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/tiles/sheets.h"

namespace app {

/// The whole drawing on one sheet of the same size, as large as the margins allow. On a layer above
/// it are the edges of all sheets and the number of each ("1-2") in its middle, in letters of
/// single strokes. Sheets that are left out have no number.
Document overviewOf(const Sheets& sheets);

} // namespace app
