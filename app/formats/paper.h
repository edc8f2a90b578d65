// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/page.h"

namespace app {

/// How a page lies on paper: in its middle, as large as fits (SVG's xMidYMid meet).
struct Paper {
    Point millimetres;         ///< the paper's size
    double millimetresPerUnit; ///< of a user unit
    Point corner;              ///< the user point at the paper's top left
};
Paper paperOf(const Page& page);

} // namespace app
