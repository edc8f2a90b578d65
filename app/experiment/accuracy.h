// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/record.h"

namespace app {

/// The errors of a variant against the exact result, which is that of the algorithm `exact`: no
/// wrong decision, and ends within one ulp of the coordinate.
struct Accuracy {
    Variant variant;
    std::uint64_t visible = 0; ///< lines that are truly visible
    std::uint64_t lost = 0;    ///< visible lines that it drops
    std::uint64_t shown = 0;   ///< invisible lines that it keeps
    std::uint64_t outside = 0; ///< lines that it gives an end outside the window (a NaN counts)
    /// Errors of ends, in ulps of the largest |coordinate| of line and window; ends of published
    /// forms may come in either order. Only of lines that are visible to both and whose ends are
    /// finite.
    double meanUlps = 0, mostUlps = 0;

    std::uint64_t wrong() const { return lost + shown; } ///< wrong decisions
};

/// All variants on the same lines; `options` give scene, field, number of lines and seed. Empty if
/// it was stopped.
std::optional<std::vector<Accuracy>> accuracies(const ExperimentOptions& options,
                                                std::span<const Variant> variants,
                                                const Follower& follower = {});

/// A row for each variant.
Table accuracyTable(std::span<const Accuracy> accuracies, const ExperimentOptions& options);

} // namespace app
