// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/sheet.h"

namespace app {

/// Where a path's own points lie in the document: point * scale + offset, on each axis. The usual
/// placement changes no bit of any number, -0 included, which is why its offset is -0.
struct Placement {
    Point scale{1, 1};
    Point offset{-0.0, -0.0};
    /// The point, rounded twice on each axis; the same bits on every machine.
    Point operator()(const Point& p) const;
    /// This placement and then `next`, as one. The usual one before or after another changes
    /// nothing; else a few roundings may differ from those of two steps.
    Placement then(const Placement& next) const;
    bool usual() const; ///< of the usual bits
    friend bool operator==(const Placement&, const Placement&) = default;
};

} // namespace app
