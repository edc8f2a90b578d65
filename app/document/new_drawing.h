// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

namespace app {

/// A drawing without objects, on an A3 sheet.
inline Document newDrawing()
{
    Document document;
    document.apply({.page = Page{{0, 0}, {420, 297}, {420, Unit::Mm}, {297, Unit::Mm}}});
    return document;
}

} // namespace app
