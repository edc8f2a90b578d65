// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/picture.h"

namespace ui {

/// One straight piece of a stroke in the layout of the vertex buffer
/// (resources/shaders/stroke.vert).
struct Instance {
    float ax, ay, bx, by; ///< logical pixels from the middle of the view
    std::uint32_t rgba;   ///< red in the lowest byte
    float width;
    std::uint32_t caps;
};
static_assert(sizeof(Instance) == 28);

/// A draw list as draw calls, bottom to top, over two arrays.
struct Batches {
    struct Batch {
        bool filled;                ///< an area; else strokes
        std::uint32_t first, count; ///< ranges of instances for strokes, of contours for an area
        app::Colour colour{};
        app::FillRule rule{};
    };
    struct Point {
        float x, y;
    };
    std::vector<Batch> batches;
    std::vector<Instance> instances;
    std::vector<Point> points;
    std::vector<std::int32_t> contourStarts, contourCounts; ///< ranges of points
};

/// Strokes that are translucent, or so wide that their joins show, become areas; other joins are
/// round. An opaque area gets an edge stroke half a pixel wide, because areas are filled without
/// anti-aliasing.
Batches batches(const app::DrawList& drawList, const glm::dvec2& viewSize);

} // namespace ui
