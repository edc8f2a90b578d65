// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/snapping/alignment.h"
#include "app/view/snapping/snap_kind.h"

#include <optional>

namespace app {

/// A place that the pointer snaps to.
struct Snap {
    Point point;
    const SnapKind* kind;
    bool corner = false;                ///< of an edge
    std::vector<AlignmentLine> lines{}; ///< what the point is aligned with

    const QString& word() const { return corner ? kind->cornerWord : kind->word; }
    friend bool operator==(const Snap&, const Snap&) = default;
};

/// Chooses among the places that the kinds offer: the one of the best rank, then the nearest; at
/// the same distance, apart from rounding, the one offered first. Places farther away than the
/// radius are ignored, and places that are not finite.
class SnapOffers {
public:
    SnapOffers(const Point& pointer, double radius) : pointer_(pointer), radius_(radius) {}

    void begin(const SnapKind& kind) { kind_ = &kind; } ///< of the next offers
    void add(const Point& place) { consider({place, kind_}, kind_->rank); }
    void addCorner(const Point& place) { consider({place, kind_, true}, SnapRank::Single); }

    const std::optional<Snap>& best() const { return best_; }
    SnapRank rank() const { return rank_; }       ///< of the best one, if any
    double distance() const { return distance_; } ///< of the best one, if any

private:
    void consider(const Snap& snap, SnapRank rank);

    Point pointer_;
    double radius_;
    const SnapKind* kind_ = nullptr;
    std::optional<Snap> best_;
    SnapRank rank_ = SnapRank::Grid;
    double distance_ = 0;
};

} // namespace app
