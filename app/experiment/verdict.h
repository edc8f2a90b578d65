// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/study.h"

namespace app {

/// What becomes of the paper's ranking in our own times, pair by pair of its algorithms. A pair
/// that is too close to call, there or here, is undecided.
struct RankingCheck {
    std::size_t same = 0, reversed = 0, undecided = 0;
    bool holds() const { return reversed == 0; }
};
RankingCheck rankingCheck(const PaperTable& paper, const Record& record, const Measure& measure);

/// What came out, in plain sentences for people who never read the paper: which is the fastest,
/// whether the paper's ranking holds, and who loses lines.
QStringList verdict(const Trial& trial, std::span<const Measure> measures);

/// Why: of which class most lines are, and what such a line costs.
QStringList reasons(const Explanation& explanation);

} // namespace app
