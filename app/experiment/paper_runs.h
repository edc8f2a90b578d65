// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

#include <QString>

#include <optional>
#include <vector>

namespace app {

/// One column of a table of the paper: the authors' times for one algorithm, in seconds.
struct PaperColumn {
    QString name; ///< as in the paper: "CS", "Prop."
    const clipping::Algorithm* algorithm;
    std::vector<double> runs;
    double printedAverage;
    std::optional<double> printedPercentage; ///< empty for the proposed method
};

/// The algorithm of a column: "Prop." is the paper's own. Null if there is no such algorithm.
const clipping::Algorithm* paperAlgorithm(const QString& name);

/// Table 1 or 2 of the paper, from resources/paper.
struct PaperTable {
    QString key; ///< "table1"
    std::uint64_t lines;
    std::vector<PaperColumn> columns; ///< in the paper's order: the proposed method is the last
};
std::vector<PaperTable> paperTables();

/// How much faster the proposed method is than another, in per cent, as the paper defines it: the
/// difference of times divided by the proposed method's time. 100 % faster is half the time.
constexpr double fasterByProposed(double other, double proposed)
{
    return 100 * (other - proposed) / proposed;
}

/// The time saved: the difference divided by the other's time. Half the time is 50 %.
constexpr double fasterByOther(double other, double proposed)
{
    return 100 * (other - proposed) / other;
}

} // namespace app
