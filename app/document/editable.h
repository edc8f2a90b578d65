// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/document/object_ranges.h"

namespace app {

/// The objects that may be selected and edited: they are shown, and their layers are not locked.
ObjectRanges editableObjects(const Document& document);

} // namespace app
