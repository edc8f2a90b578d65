// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

namespace app {

/// For formats whose y points up: what the y of a point in the file and in the drawing add up to,
/// in user units. The lower left corner of a page that begins at the user origin, as a sheet of
/// paper does, is the origin of the file. In any other drawing numbers mean something, and the user
/// origin stays the origin. A part of a drawing lies where it would lie in the whole.
inline double heightOfPlane(const Page& page, const WriteOptions& options)
{
    const clipping::Window whole = options.wholePage.value_or(page.rectangle());
    return options.paged && whole.min == Point{0, 0} ? whole.max.y : 0;
}

} // namespace app
