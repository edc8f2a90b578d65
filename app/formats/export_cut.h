// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/cut.h"
#include "app/formats/write_result.h"

namespace app {

/// How an export ended, and what was cut.
struct CutExport : WriteResult {
    CutCounts counts{};
};

/// Cuts a drawing and writes what remains to a file, in the format of its extension, on any thread.
CutExport exportCut(const Document& document, CutOptions options, const QString& path,
                    const std::stop_token& stop);

} // namespace app
