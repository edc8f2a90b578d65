// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/page.h"

namespace app {

/// The position of a page on paper: centred, as large as fits (SVG's xMidYMid meet).
struct Paper {
    Point millimetres;         ///< the size of the paper
    double millimetresPerUnit; ///< the size of a user unit
    Point corner;              ///< the document point at the top left corner of the paper
};
Paper paperOf(const Page& page);

} // namespace app
