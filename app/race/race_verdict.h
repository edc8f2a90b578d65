// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/ranking.h"
#include "app/race/race_lane.h"
#include "app/scene/window_needs.h"

namespace app {

/// One statement about a race. `first` is a whole sentence by itself, `rest` more of them or empty.
struct RaceStatement {
    enum class Kind : std::uint8_t {
        Agreement,   ///< which forms give the same result as exact arithmetic
        Differences, ///< which do not, and on how many lines
        Limits,      ///< which algorithms cannot clip at which windows
        Ties,        ///< whose times do not differ significantly
        Untimed,     ///< why there are no times
    };
    Kind kind;
    QString first, rest{};
    std::optional<Variant> variant{}; ///< that `first` is about, of differences

    friend bool operator==(const RaceStatement&, const RaceStatement&) = default;
};

/// The race that a verdict is about.
struct RaceOutcome {
    std::span<const RaceRow> rows;         ///< without times: nothing was measured
    std::size_t lines = 0;                 ///< of the drawing
    std::span<const NamedNeeds> windows{}; ///< all visible windows of the drawing
    const Ranking* ranking = nullptr;      ///< of the rows' times; null: not known (yet)
    QString where{};                       ///< the window of the race, if there are others
};

/// At most one statement of each kind, in the order of the kinds.
std::vector<RaceStatement> verdictOf(const RaceOutcome& outcome);

} // namespace app
