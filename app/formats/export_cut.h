// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/cut.h"

#include <optional>
#include <stop_token>

namespace app {

/// How an export ended. The file is complete, or as it was before.
struct CutExport {
    enum class End : std::uint8_t { Written, Failed, Stopped };
    End end = End::Written;
    QString error{}; ///< a sentence that names the file, if it failed
    CutCounts counts{};
};

/// Cuts a drawing and writes what remains to a file, in the format of its extension, on any thread.
CutExport exportCut(const Document& document, CutOptions options, const QString& path,
                    const std::stop_token& stop);

} // namespace app
