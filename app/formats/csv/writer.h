// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

namespace app::csv {

/// One row a line, after a header: x1,y1,x2,y2,layer,colour,width and, if `options.sources` is
/// given, source. Curves as their chords; what is only filled has its outline in the fill's colour.
std::optional<QString> write(const Document& document, QIODevice& out, const WriteOptions& options);

} // namespace app::csv
