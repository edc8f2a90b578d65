// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/underlay.h"
#include "app/scene/region.h"

namespace app {

/// The rectangle around all that the windows keep, at which images are cut; `min > max` on an axis
/// if that is nothing. Empty: what is kept has no end.
std::optional<clipping::Window> keptBox(const ClipRegion& region);

/// What is left of an image inside that rectangle; none: nothing. Without the rectangle, the image is
/// whole, or gone if it lies wholly in what the windows remove.
SharedUnderlay keptOf(const SharedUnderlay& image, const ClipRegion& region);
/// Whether all that is left of the image lies in what the windows keep, as far as is cheap to tell:
/// they are one rectangle, or none, or the image is wholly inside.
bool isCutExactly(const Underlay& image, const ClipRegion& region);

} // namespace app
