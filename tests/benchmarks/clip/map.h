// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <string>
#include <vector>

/// A map drawn by somebody else: its outlines as segments, in their order.
struct Map {
    std::string source; ///< where it comes from; or why there is none
    clipping::Window around;
    std::vector<clipping::Segment> segments; ///< empty: there is none on this machine
};

/// The world map of Debian's package openclipart-svg, curves flattened as in the editor.
const Map& realMap();
