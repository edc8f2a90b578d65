// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/looking.h"

#include "clipping/algorithm.h"

#include <algorithm>

namespace app {

namespace {

constexpr double wellSeen = 40;           // pixels
constexpr double leastOfClipWindow = 0.1; // least share of the clip window to show
constexpr double pieceOfView = 0.2;       // share of the view that a small piece fills
constexpr double longPieceOfView = 0.8;   // the same, for one longer than the clip window

double longest(const clipping::Window& w) { return std::max(w.max.x - w.min.x, w.max.y - w.min.y); }

bool containsWindow(const clipping::Window& all, const clipping::Window& part)
{
    return all.min.x <= part.min.x && all.min.y <= part.min.y && part.max.x <= all.max.x
           && part.max.y <= all.max.y;
}

/// The zoom, in pixels per unit, at which the piece and its surroundings fill the shorter side of
/// the view.
double zoomFor(const View& view, double piece, double clipWindow)
{
    const double enough = std::max(clipWindow, piece / longPieceOfView);
    const double extent =
        std::max(leastOfClipWindow * clipWindow, std::min(piece / pieceOfView, enough));
    return extent > 0 ? std::min(view.size.x, view.size.y) / extent : view.zoom;
}

} // namespace

View lookingAt(const View& view, const clipping::Window& piece, const clipping::Window& clipWindow)
{
    View to = view;
    const double pixels = longest(piece) * view.zoom;
    const bool fits = pixels <= longPieceOfView * std::min(view.size.x, view.size.y);
    if (pixels >= wellSeen && containsWindow(view.visible(), piece))
        return view;
    const double zoom = zoomFor(view, longest(piece), longest(clipWindow));
    if (!fits)
        to.zoom = std::min(zoom, view.zoom);
    else if (pixels < wellSeen)
        to.zoom = std::max(zoom, view.zoom);
    to.centre = (piece.min + piece.max) * 0.5;
    return to;
}

View bringing(const View& view, const clipping::Segment& line)
{
    if (clipping::exactAlgorithm().corrected.clip(line, view.visible()))
        return view;
    View to = view;
    to.centre = (line.a + line.b) * 0.5;
    return to;
}

} // namespace app
