// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/reasons.h"
#include "app/experiment/study.h"

namespace app {

/// What becomes of the paper's ranking, which is that of its averages, in our own times, pair by
/// pair of its algorithms. A pair that does not differ significantly here is undecided, and a
/// ranking of which a pair is undecided does not hold: nothing contradicts it.
struct RankingCheck {
    std::size_t same = 0, reversed = 0, undecided = 0;
    bool holds() const { return reversed + undecided == 0; }
};
RankingCheck rankingCheck(const PaperTable& paper, const Record& record, const Measure& measure);

/// What came out, in plain sentences for people who never read the paper: which is the fastest,
/// whether the paper's ranking holds, and who loses lines.
QStringList verdict(const Trial& trial, std::span<const Measure> measures);

} // namespace app
