// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

namespace app {

/// One halving of midpoint subdivision.
struct Halving {
    bool forB;                  ///< the visible part's end on b's side is looked for
    double t;                   ///< of the midpoint
    unsigned nearCode, farCode; ///< outcodes of what is kept, afterwards
};
/// The first halvings of each search, at most so many. They are the corrected form's.
std::vector<Halving> halvings(const clipping::Segment& line, const clipping::Window& window,
                              std::size_t most);

} // namespace app
