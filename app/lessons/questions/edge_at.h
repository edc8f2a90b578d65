// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/question.h"

namespace app {

/// The edge of the window on which an end lies that the window has cut.
inline clipping::Edge edgeAt(const Point& p, const clipping::Window& window)
{
    return p.x == window.min.x   ? clipping::Edge::Left
           : p.x == window.max.x ? clipping::Edge::Right
           : p.y == window.min.y ? clipping::Edge::Bottom
                                 : clipping::Edge::Top;
}

} // namespace app
