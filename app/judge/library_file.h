// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

namespace app::plug_in {

/// Why a file is no shared library, and what makes one of it.
struct NoLibrary {
    QString sentence;
    QString command{}; ///< for a shell; empty where none is known
};

/// Of source code, an object file, a program, another text. Nothing if the file begins like a
/// shared library, or cannot be read: then the loader says more.
std::optional<NoLibrary> whyNoLibrary(const QString& path);

} // namespace app::plug_in
