// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

namespace app::plug_in {

/// Why a file is not a shared library, and the command that makes one from it.
struct NoLibrary {
    QString sentence;
    QString command{}; ///< for a shell; empty if none is known
};

/// Recognizes source code, object files, programs and other texts. Empty if the file begins like a
/// shared library or cannot be read: then the loader's message says more.
std::optional<NoLibrary> whyNoLibrary(const QString& path);

} // namespace app::plug_in
