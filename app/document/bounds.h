// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_ranges.h"
#include "app/document/scene.h"

#include <optional>

namespace app {

/// What objects cover; nothing if they have no segments. It looks at each of their segments: for
/// the selection there is Session::selectionBounds().
std::optional<clipping::Window> boundsOf(const Scene& scene, const ObjectRanges& objects);

} // namespace app
