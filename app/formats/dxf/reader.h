// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

namespace app::dxf {

/// Reads a DXF file of the versions R12 to 2018 (AC1009 to AC1032), text or binary. A user unit is
/// the unit of the file, so coordinates stay as they are, apart from the sign of y; the page is the
/// rectangle around all shapes. Of a file that is damaged or ends early, what comes before is read.
/// The unit of the options counts before that of the file.
Result<Imported> read(QIODevice& in, const ReadOptions& options);

} // namespace app::dxf
