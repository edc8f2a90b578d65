// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/formats/write_result.h"

#include <QDateTime>

namespace app {

/// How a save ended.
struct Saved : WriteResult {
    QDateTime fileTime{}; ///< last change of the file, if it was written
};

/// Writes a drawing to its file, on any thread. If a signal ends the process meanwhile,
/// removeUnfinished() removes the incomplete temporary file. One save at a time.
Saved save(const Document& document, const QString& path, const std::stop_token& stop = {});

} // namespace app
