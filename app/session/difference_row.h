// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QString>

#include <array>
#include <span>

namespace app {

/// One column of the list of what differs. A difference is one of `session.differences.found()`.
struct DifferenceColumn {
    /// What rows are sorted by, and then by line.
    using Key = std::array<double, 2>;

    QString (*heading)(const Comparison& comparison); ///< "Line"
    QString (*meaning)(const Comparison& comparison); ///< of what is in it, a sentence
    /// As a person reads it, in the drawing's unit. Empty if the line is gone, or no panel shows
    /// it.
    QString (*text)(const Session& session, const Difference& difference);
    Key (*key)(const Session& session, const Difference& difference);
    bool number; ///< stands to the right
};
std::span<const DifferenceColumn> differenceColumns();

/// What both leave of the line, with all digits, in user units; empty as above.
QString piecesInFull(const Session& session, const Difference& difference);

/// The rows sorted by a column: indices into `found().list`. Equal ones are ascending by line.
std::vector<std::uint32_t> sortedBy(const Session& session, const DifferenceColumn& column,
                                    Qt::SortOrder order);

} // namespace app
