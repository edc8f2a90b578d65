// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

namespace app::svg {

/// The bounding box of an element's shapes.
struct ElementBounds {
    bool ofStrokes = false; ///< whether their strokes count, too
    Point min{}, max{};
    bool isEmpty = true;
    bool isKnown = true; ///< whether they have no images and the like
};

/// Makes the box as large as is needed for the path, whose curves it touches.
void include(ElementBounds& bounds, const Subpath& path);

} // namespace app::svg
