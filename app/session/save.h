// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

#include <QDateTime>

#include <optional>
#include <stop_token>

namespace app {

/// How a save ended. The file is complete, or as it was before.
struct Saved {
    enum class End : std::uint8_t { Written, Failed, Stopped };
    End end = End::Written;
    QString error{};      ///< a sentence that names the file, if it failed
    QDateTime fileTime{}; ///< last change of the file, if it was written
};

/// Writes a drawing to its file, on any thread. If a signal ends the process meanwhile,
/// removeUnfinished() removes the incomplete temporary file. One save at a time.
Saved save(const Document& document, const QString& path, const std::stop_token& stop = {});

} // namespace app
