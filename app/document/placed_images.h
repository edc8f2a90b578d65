// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/containers.h"

namespace app {

/// The tree with its images moved and resized.
Containers withPlacedImages(Containers tree, const Placement& where);

/// The tree without the images that another one shows at the same place.
Containers withoutImagesOf(Containers tree, const Containers& other);

} // namespace app
