// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_view.h"

namespace app {

/// Whether the object encloses an area that can be filled; single straight lines do not. (SVG fills
/// shapes that have no fill attribute, and some programs and PDF viewers then paint a hairline
/// there.)
bool hasArea(const ObjectView& object);

/// The colour of an object's lines if nothing is filled: its stroke colour or, without a stroke,
/// its fill colour if it has an area. Empty if the object is invisible.
std::optional<Colour> lineColour(const ObjectView& object);
std::optional<Colour> lineColour(const Object& object);

} // namespace app
