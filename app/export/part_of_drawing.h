// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/document/object_ranges.h"

namespace app {

/// The drawing without the images of layers other than this one and those in it; 0: without any.
Document onlyImagesIn(Document document, ContainerId layer);

/// The document with only these objects, in their layers and groups; containers without objects are
/// left out.
Document onlyObjects(Document document, const ObjectRanges& objects);

/// A page just as large as the rectangle, with a user unit of the same size.
Page paperAround(Page page, const clipping::Window& rectangle);

} // namespace app
