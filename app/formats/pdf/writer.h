// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

namespace app::pdf {

/// One page of the drawing's size on paper. Strokes are strokes, in user units with all their
/// digits, curves are curves, dashes are dashes and see-through inks are see-through; the same
/// drawing gives the same bytes. (QPdfWriter rounds the page to whole points and turns strokes
/// with alpha into filled outlines.)
std::optional<QString> write(const Document& document, QIODevice& out, const WriteOptions& options);

} // namespace app::pdf
