// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

namespace app {

/// The objects that are hidden themselves or by a container around them.
ObjectRanges hiddenObjects(const Document& document);

/// The document without hidden objects and hidden containers.
Document withoutHidden(Document document);

} // namespace app
