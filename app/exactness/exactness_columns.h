// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exactness/error_class.h"

#include <QString>

namespace app {

/// One column of the list of judged lines.
struct ExactnessColumn {
    QString heading;
    QString meaning; ///< what the column shows, a sentence
    QString (*text)(const LineExactness& line);
    double (*key)(const LineExactness& line); ///< rows are sorted by this key, then by line
    bool number;                              ///< aligned to the right
};
std::span<const ExactnessColumn> exactnessColumns();

/// The index of the column of errors. The list is first sorted by it, the worst first.
constexpr int errorColumn = 2;

/// The rows sorted by a column: indices into the list. Equal rows are ascending by line.
std::vector<std::uint32_t> sortedBy(std::span<const LineExactness> list,
                                    const ExactnessColumn& column, Qt::SortOrder order);

} // namespace app
