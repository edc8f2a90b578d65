// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

#include <QString>

#include <span>
#include <vector>

namespace app {

/// A way to clip that was printed by mistake, shown so that people find the fault. It is no
/// row of the library's catalogue, and keeps nothing of its contract but that it ends.
struct Exhibit {
    QString key;         ///< "md-step-2"
    QString name;        ///< translated, as is what follows: "MD with Step 2 as printed"
    QString whatIsWrong; ///< what was printed, what it should read, what comes of it
    const clipping::Algorithm* meant; ///< what it should have been
    /// As in `clipping::Uses`.
    std::size_t (*clipAll)(std::span<const clipping::Segment> in, const clipping::Window& window,
                           std::span<clipping::Clipped> out);
};

/// Every one, in menu order.
const std::vector<Exhibit>& exhibits();

} // namespace app
