// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

namespace app::plug_in {

/// Why a file is no shared library: source code, an object file, a program, another text. One
/// sentence with the command line that makes a library of it where there is one. Nothing if the
/// file begins like a shared library, or cannot be read: then the loader says more.
std::optional<QString> whyNoLibrary(const QString& path);

} // namespace app::plug_in
