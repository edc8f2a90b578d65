// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <vector>

namespace app {

/// The part of the drawing that a canvas shows; independent of any screen. Screen points are
/// logical pixels of the canvas, y down.
class View {
public:
    glm::dvec2 size{1, 1}; ///< size of the canvas in logical pixels
    Point centre{0, 0};    ///< the document point at the centre of the canvas
    double zoom = 1;       ///< logical pixels per user unit

    Point toScreen(const Point& p) const { return (p - centre) * zoom + size * 0.5; }
    Point toDrawing(const Point& s) const { return (s - size * 0.5) / zoom + centre; }
    clipping::Window visible() const { return {toDrawing({0, 0}), toDrawing(size)}; }

    void pan(const glm::dvec2& pixels) { centre -= pixels / zoom; }
    /// Zooms by `factor`; the document point under `screen` keeps its place.
    void zoomAt(const Point& screen, double factor);
    /// Shows a rectangle as large as possible, with a margin in pixels.
    static constexpr double usualMargin = 24; ///< pixels
    void fit(const clipping::Window& rectangle, double margin = usualMargin);

    friend bool operator==(const View&, const View&) = default;
};

} // namespace app
