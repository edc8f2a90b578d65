// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace app {

/// What people read over a column of an experiment's table, and as its explanation.
struct Heading {
    QString text;    ///< at most two lines; of a name that is none of ours: the name itself
    QString meaning; ///< one sentence; may be empty
};

/// Of a name of a table: "median_ns" is "Median, ns".
Heading headingOf(const QString& name);

} // namespace app
