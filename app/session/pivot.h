// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_ranges.h"
#include "app/document/path.h"

#include <optional>

namespace app {

class Session;

/// The point about which the selection is rotated, flipped, scaled and skewed: the middle of its
/// box, unless a person put it elsewhere. It belongs to this selection at its place: for another
/// selection, or after another change of it, the middle counts again.
class Pivot {
public:
    explicit Pivot(const Session& session) : session_(session) {}

    Point at() const;
    bool isMoved() const; ///< it was put elsewhere
    void put(const Point& place);

private:
    const Session& session_;
    std::optional<Point> put_;
    ObjectRanges selection_;    ///< to which it belongs,
    clipping::Window bounds_{}; ///< as it was
};

} // namespace app
