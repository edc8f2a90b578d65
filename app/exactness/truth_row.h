// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exactness/error_class.h"

#include <QString>

namespace app {

/// One column of the list of lines that were judged.
struct TruthColumn {
    QString heading;
    QString meaning; ///< of what is in it, a sentence
    QString (*text)(const LineTruth& line);
    double (*key)(const LineTruth& line); ///< what rows are sorted by, and then by line
    bool number;                          ///< stands to the right
};
std::span<const TruthColumn> truthColumns();

/// The column of the errors, and the worst first, are how the list begins.
constexpr int errorColumn = 2;

/// The rows sorted by a column: indices into the list. Equal ones are ascending by line.
std::vector<std::uint32_t> sortedBy(std::span<const LineTruth> list, const TruthColumn& column,
                                    Qt::SortOrder order);

} // namespace app
