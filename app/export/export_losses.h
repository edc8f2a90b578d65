// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/export/export_drawing.h"

namespace app {

/// What a file of the chosen format does not hold, a remark each: "2 hidden objects are left out".
/// `left` are those objects of `chosen` of which the cut leaves something.
QStringList exportLosses(const ExportJob& job, const Document& chosen, const ObjectRanges& left,
                         const ExportDrawing& made);

} // namespace app
