// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <QStringList>

namespace app {

/// From one baseline to the next, in heights of capital letters.
constexpr double linePitch = 1.7;

/// A text as paths in units of its font: y down, from the start of the first baseline.
struct Letters {
    double capital = 1; ///< the height of capital letters
    std::vector<Subpath> paths{};
    QStringList missing{}; ///< each character that the font lacks, once; a box stands in its place
};

} // namespace app
