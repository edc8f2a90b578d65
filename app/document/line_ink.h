// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_view.h"

namespace app {

/// Whether the object has an area to fill; single straight lines have none. (SVG fills shapes
/// without a fill attribute, and some programs and PDF viewers then paint a hairline there.)
bool hasArea(const ObjectView& object);

/// The colour of an object's lines where nothing is filled: its stroke's or, without one, that of
/// its fill if there is an area to fill; nothing if the object is not seen.
std::optional<Colour> lineInk(const ObjectView& object);
std::optional<Colour> lineInk(const Object& object);

} // namespace app
