// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/page.h"

#include <QString>

namespace app {

/// The position of a page on paper: centred, as large as fits (SVG's xMidYMid meet).
struct Paper {
    Point millimetres;         ///< the size of the paper
    double millimetresPerUnit; ///< the size of a user unit
    Point corner;              ///< the document point at the top left corner of the paper
};
Paper paperOf(const Page& page);

/// Why nothing can be calculated on a page, as a sentence: it has no size, or its unit is beyond
/// the range of numbers.
std::optional<QString> faultOf(const Page& page);

} // namespace app
