// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

namespace app {

/// The objects that are hidden, themselves or with a container around them.
ObjectRanges hiddenObjects(const Document& document);

/// The document without them, and without the containers that are hidden.
Document withoutHidden(Document document);

} // namespace app
