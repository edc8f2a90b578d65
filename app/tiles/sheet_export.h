// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/write_result.h"
#include "app/tiles/sheets.h"

namespace app {

/// Writes the sheets to files named by `pattern`, which may have a folder, on any thread. The
/// format is that of its ending. Hidden objects are left out where the format cannot hide them.
/// Complete files stay if a later one fails or if the export is stopped.
WriteResult exportSheets(Sheets sheets, const QString& pattern, const Follower& follower);

} // namespace app
