// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/benchmarks/clip/map_scene.h"

/// The real map side by side; where it is not installed, pens' strokes of the same length, whose
/// name says so.
inline Scene<double> mapLines(std::size_t count)
{
    auto scene = mapSheets<double>(count);
    if (!scene.segments.empty())
        return scene;
    scene = strokes<double>(count);
    scene.name = "made lines in place of the map";
    return scene;
}
