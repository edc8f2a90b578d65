// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace app {

/// Replaces `removed` objects, from number `first` on, by `added` objects.
struct Splice {
    std::uint32_t first = 0, removed = 0, added = 0;
    friend bool operator==(const Splice&, const Splice&) = default;
};

} // namespace app
