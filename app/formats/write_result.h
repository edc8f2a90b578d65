// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <functional>
#include <optional>
#include <stop_token>

namespace app {

/// How writing a file ended. The file is complete, or as it was before.
struct WriteResult {
    enum class End : std::uint8_t { Written, Failed, Stopped };
    End end = End::Written;
    QString error{}; ///< a sentence that names the file, if it failed
};

/// The result of `write`, which returns nothing or the error, and which ends early if `stop` is
/// requested. `outOfMemory` is the error if there is not enough memory.
WriteResult resultOf(const std::function<std::optional<QString>()>& write,
                     const std::stop_token& stop, const QString& outOfMemory);

} // namespace app
