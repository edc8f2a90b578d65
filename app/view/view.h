// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <optional>
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

/// The views before and after the present one, like the pages of a browser. Views in quick
/// succession (a drag, wheel notches) count as one.
class ViewHistory {
public:
    /// Call before the view changes from `view`. `now` is in milliseconds of any clock.
    void leave(const View& view, long long now);
    std::optional<View> back(const View& present);
    std::optional<View> forth(const View& present);

private:
    std::vector<View> before_, after_;
    long long last_ = -1'000'000;
};

/// Zooms with the wheel. If the pointer does not move, turning back by the same number of notches
/// restores the view bit for bit.
class WheelZoom {
public:
    /// One notch zooms by 20 %; a touchpad reports fractions of a notch. Positive zooms in.
    void turn(View& view, const Point& screen, double notches);

private:
    struct Start {
        View view;
        Point screen;
        double notches;
        View last; ///< the view that this wheel set last: from any other view it starts again
    };
    std::optional<Start> start_;
};

/// The view in which to show a piece of a line: unchanged if the piece is clearly visible; moved if
/// it is large enough but elsewhere; otherwise zoomed so that its surroundings are visible too.
View lookingAt(const View& view, const clipping::Window& piece, const clipping::Window& clipWindow);

/// The view, moved so that part of the line is visible if no part was; never zoomed.
View bringing(const View& view, const clipping::Segment& line);

} // namespace app
