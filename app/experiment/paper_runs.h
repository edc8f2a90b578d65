// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

#include <QString>

#include <optional>
#include <vector>

namespace app {

/// One column of a table of the paper: what its authors measured for one algorithm, in seconds.
struct PaperColumn {
    QString name; ///< as the paper has it: "CS", "Prop."
    const clipping::Algorithm* algorithm;
    std::vector<double> runs;
    double printedAverage;
    std::optional<double> printedPercentage; ///< the proposed one's has none
};

/// The algorithm of a column: "Prop." is the paper's own. Null if there is no such.
const clipping::Algorithm* paperAlgorithm(const QString& name);

/// Table 1 or 2 of the paper, from resources/paper.
struct PaperTable {
    QString key; ///< "table1"
    std::uint64_t lines;
    std::vector<PaperColumn> columns; ///< in the paper's order: the proposed one is the last
};
std::vector<PaperTable> paperTables();

/// How much faster the proposed one is than another, in per cent, as the paper says it: the time
/// between them divided by the proposed one's. 100 % faster is half the time.
constexpr double fasterByProposed(double other, double proposed)
{
    return 100 * (other - proposed) / proposed;
}

/// The same as time saved: divided by the other's time. Half the time is 50 %.
constexpr double fasterByOther(double other, double proposed)
{
    return 100 * (other - proposed) / other;
}

} // namespace app
