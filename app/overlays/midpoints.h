// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

namespace app {

/// One halving of midpoint subdivision.
struct Halving {
    bool forB;                  ///< the search for the end of the visible part on b's side
    double t;                   ///< parameter of the midpoint
    unsigned nearCode, farCode; ///< outcodes of the half that is kept, after this step
};
/// The first halvings of each search, at most `most` of each, by the corrected form.
std::vector<Halving> halvings(const clipping::Segment& line, const clipping::Window& window,
                              std::size_t most);

} // namespace app
