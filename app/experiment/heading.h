// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace app {

/// The heading of a column in an experiment's table, and its explanation.
struct Heading {
    QString text;    ///< at most two lines; for an unknown name, the name itself
    QString meaning; ///< one sentence; may be empty
};

/// For a column's name in a table: "median_ns" gives "Median, ns".
Heading headingOf(const QString& name);

} // namespace app
