// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

#include <functional>

namespace app::pdf {

/// Writes one page of the drawing's size on paper. Strokes stay strokes in user units with full
/// precision, curves stay curves, dashes stay dashes, and translucent colours stay translucent. The
/// same drawing gives the same bytes. (QPdfWriter rounds the page size to whole points and turns
/// translucent strokes into filled outlines.)
std::optional<QString> write(const Document& document, QIODevice& out, const WriteOptions& options);

/// Makes the drawing of a page when it is written, so that only one of them is in memory.
using PageMaker = std::function<Document(std::size_t page)>;
/// The same with a page for each drawing.
std::optional<QString> writePages(std::size_t count, const PageMaker& page, QIODevice& out,
                                  const WriteOptions& options);

} // namespace app::pdf
