// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

namespace app::svg {

/// An SVG drawing as a document: transforms applied, styles computed, <use> drawn out, hidden
/// things kept hidden. The sentence of a failure begins with the line ("line 212 is not complete
/// ..."). Ends soon and within the memory that limits.h implies, whatever the file holds.
Result<Imported> read(QIODevice& in);

} // namespace app::svg
