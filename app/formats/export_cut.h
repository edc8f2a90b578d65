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
/// A stop request before the end leaves the disk unchanged.
CutExport exportCut(const Document& document, const CutOptions& options, const QString& path,
                    const Follower& follower);

} // namespace app
