// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/export/export_choice.h"

#include <QString>

namespace app {

/// What the name of a file says of the area that is in it: "-cut", "-page", "-selection", or the
/// name of the window or layer, as far as a file may be called so.
QString exportName(const ExportArea& area, const Document& document);

} // namespace app
