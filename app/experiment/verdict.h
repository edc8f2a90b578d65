// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/reasons.h"
#include "app/experiment/study.h"

namespace app {

/// Whether the paper's ranking, by its averages, holds in our times, for each pair of its
/// algorithms. A pair that does not differ significantly here is undecided. A ranking with
/// undecided pairs does not hold, even if nothing contradicts it.
struct RankingCheck {
    std::size_t same = 0, reversed = 0, undecided = 0;
    bool holds() const { return reversed + undecided == 0; }
};
RankingCheck rankingCheck(const PaperTable& paper, const Record& record, const Measure& measure);

/// The result in plain sentences for people who have not read the paper: which variant is the
/// fastest, whether the paper's ranking holds, and which variants lose lines.
QStringList verdict(const Trial& trial, std::span<const Measure> measures);

} // namespace app
