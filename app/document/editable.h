// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_ranges.h"
#include "app/document/sheet.h"

namespace app {

/// The objects that may be selected and edited: they are shown, and their layers are not locked.
ObjectRanges editableObjects(const Sheet& sheet);

} // namespace app
