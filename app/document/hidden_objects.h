// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/document/object_ranges.h"

namespace app {

/// The objects that are hidden themselves or by a container around them.
ObjectRanges hiddenObjects(const Document& document);

/// The document without hidden objects and hidden containers.
Document withoutHidden(Document document);

/// The objects that may be selected and edited: shown, and in no locked container.
ObjectRanges editableObjects(const Document& document);

} // namespace app
