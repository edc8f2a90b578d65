// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/record.h"

namespace app {

/// How far a variant is from the truth, which is what the row `exact` says: no wrong decision,
/// and ends within one ulp of the coordinate.
struct Accuracy {
    Variant variant;
    std::uint64_t visible = 0; ///< lines that are truly visible
    std::uint64_t lost = 0;    ///< of these, those that it drops
    std::uint64_t shown = 0;   ///< lines that are not visible and that it keeps
    std::uint64_t outside =
        0; ///< lines that it gives an end outside the window (not a number counts)
    /// How far ends are off, in ulps of the largest |coordinate| of line and window; ends of
    /// published forms may come in either order. Of lines that both see and whose ends are numbers.
    double meanUlps = 0, mostUlps = 0;

    std::uint64_t wrong() const { return lost + shown; } ///< decisions
};

/// All variants on the same lines: scene, field, lines, and seed are the options'. Nothing if it
/// was stopped.
std::optional<std::vector<Accuracy>> accuracies(const ExperimentOptions& options,
                                                std::span<const Variant> variants,
                                                const Follower& follower = {});

/// One row a variant.
Table accuracyTable(std::span<const Accuracy> accuracies, const ExperimentOptions& options);

} // namespace app
