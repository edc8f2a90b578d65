// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

namespace app {

/// The drawing as a format holds it, to be made before it is cut: as lines no farther than
/// `tolerance` (user units, > 0) from its curves, so that each of them is inside; or without fills
/// behind strokes, so that the border of a cut area is no further line.
Document asHeld(Document document, const Format& format, double tolerance);

/// What of these objects a file does not hold, a remark each: "2 areas lose their fill". Nothing is
/// said of hidden objects that the format cannot hide.
QStringList lossesOf(const Document& document, const ObjectRanges& objects, const Format& format,
                     const WriteOptions& options);

} // namespace app
