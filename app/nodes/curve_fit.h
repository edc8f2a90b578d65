// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/bezier.h"

#include <span>

namespace app {

/// One curve in place of several that follow each other: it keeps the ends and the directions
/// there, and is otherwise as near to them as can be (least squares). Pieces of one curve give that
/// curve again. There is at least one piece, and all numbers are finite. The distance is measured at
/// that many places of a piece.
Bezier fitted(std::span<const Bezier> pieces, std::size_t places = 32);

} // namespace app
