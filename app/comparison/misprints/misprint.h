// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

#include <QString>

#include <vector>

namespace app {

/// A known misprint: a clipping algorithm as it was misprinted, shown so that people find the
/// error. It is not in the library's catalogue. Of the library's contract it keeps only that it
/// ends.
struct Misprint {
    QString key;         ///< "md-step-2"
    QString name;        ///< translated, like the next text: "MD with Step 2 as printed"
    QString whatIsWrong; ///< what was printed, what it should be, and the consequence
    const clipping::Algorithm* meant; ///< the correct algorithm
    /// The row of the algorithm meant, with the misprint and its pseudo-code as the published form.
    clipping::Algorithm row;
};

/// All known misprints, in menu order.
const std::vector<Misprint>& misprints();

} // namespace app
