// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

namespace app {

/// A drawing whose coordinates are those that a file with limited decimals holds.
struct Rounded {
    Document document;
    std::size_t points = 0; ///< paths that would become points, and are left out
};

/// Rounds all coordinates of a path as `options` says; empty: it becomes a point.
std::optional<Subpath> rounded(const Subpath& path, const WriteOptions& options);

/// Rounds all coordinates as `options` says. No path goes to a point where it already is; one that
/// is nothing but a point remains only if it was a point before. Without a limit nothing changes.
Rounded rounded(Document document, const WriteOptions& options);

} // namespace app
