// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIODevice>

#include <string_view>

namespace app {

/// Writes all bytes; false on failure. A full disk first accepts a part, and only the next write
/// fails: then `out.errorString()` gives the reason.
inline bool writeAll(QIODevice& out, std::string_view bytes)
{
    while (!bytes.empty()) {
        const qint64 written = out.write(bytes.data(), qint64(bytes.size()));
        if (written <= 0)
            return false;
        bytes.remove_prefix(std::size_t(written));
    }
    return true;
}

} // namespace app
