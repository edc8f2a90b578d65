// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/race/race_pairs.h"

namespace app {

/// The scale of times that all rows of a race share: from 0 to a round number, in one unit.
struct RaceLane {
    double most = 0; ///< milliseconds: 1, 2 or 5 × 10ⁿ; 0 without times

    QString unit() const; ///< "µs", "ms" or "s": `most` is at least 1 of it; "ms" without times
    /// The time in that unit, without its name, with so many significant digits: "0.231", "50.7",
    /// "1,234". No digit before the decimal point is lost.
    QString number(double milliseconds, int digits) const;
    QString text(double milliseconds, int digits = 3) const; ///< "50.7 µs"
    QString end() const;                                     ///< "200 µs"
    double share(double milliseconds) const;                 ///< of the lane: 0 to 1

    friend bool operator==(const RaceLane&, const RaceLane&) = default;
};

/// A lane for all medians. If they almost fill it, it stays as long as it was `before`, so that it
/// does not jump while times are measured.
RaceLane laneOf(std::span<const RacePair> pairs, const RaceLane& before = {});

} // namespace app
