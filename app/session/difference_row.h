// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QString>

#include <array>
#include <span>

namespace app {

/// One column of the list of differences. A difference is one of `session.differences.found()`.
struct DifferenceColumn {
    /// Rows are sorted by this key, then by line.
    using Key = std::array<double, 2>;

    QString (*heading)(const Comparison& comparison); ///< "Line"
    QString (*meaning)(const Comparison& comparison); ///< what the column shows, a sentence
    /// The displayed text, with lengths in the drawing's unit. Empty if the line no longer exists,
    /// or if no panel shows differences.
    QString (*text)(const Session& session, const Difference& difference);
    Key (*key)(const Session& session, const Difference& difference);
    bool number; ///< aligned to the right
};
std::span<const DifferenceColumn> differenceColumns();

/// The pieces of both variants with all digits, in user units; empty as above.
QString piecesInFull(const Session& session, const Difference& difference);

/// The rows sorted by a column: indices into `found().list`. Equal rows are ascending by line.
std::vector<std::uint32_t> sortedBy(const Session& session, const DifferenceColumn& column,
                                    Qt::SortOrder order);

} // namespace app
