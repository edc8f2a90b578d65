// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

namespace app::csv {

/// Reads lines as a drawing: one object for each row. A first row that does not start with a number
/// is a header that names the columns: x1,y1,x2,y2 (or by other usual names, columns.cpp) and
/// optionally layer, colour and width, in any order; `source` is skipped, other columns are
/// reported. Without a header the columns come in this order. Between them there are commas, or
/// semicolons, tabs or blanks (dialect.h). The page is the rectangle around the lines, with a user
/// unit of one pixel, as the file has no page. An error sentence begins with the line ("line 12 has
/// ..."), if it is about one. A file that does not fit into memory is refused after its first rows.
Result<Imported> read(QIODevice& in);

} // namespace app::csv
