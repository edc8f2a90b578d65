// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

namespace app::csv {

constexpr std::size_t mostRows = 5'000'000;

/// Lines as a drawing: one row, one object. A first row that is not numbers is a header and names
/// the columns (x1,y1,x2,y2, and layer, colour, width in any order; `source` is passed over, others
/// are reported); without one they come in this order. The page is the rectangle around the lines,
/// a user unit one pixel; the file has no page of its own. The sentence of a failure begins with
/// the line ("line 12 has ...").
Result<Imported> read(QIODevice& in);

} // namespace app::csv
