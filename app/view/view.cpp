// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/view.h"

#include "clipping/algorithm.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace app {

constexpr double leastZoom = 1e-9, mostZoom = 1e9;

void View::zoomAt(const Point& screen, double factor)
{
    const Point anchor = toDrawing(screen);
    zoom = std::clamp(zoom * factor, leastZoom, mostZoom);
    centre = anchor - (screen - size * 0.5) / zoom;
}

void View::fit(const clipping::Window& rectangle, double margin)
{
    const glm::dvec2 extent = rectangle.max - rectangle.min;
    const glm::dvec2 room = glm::max(size - 2 * margin, glm::dvec2(1));
    const double x = extent.x > 0 ? room.x / extent.x : mostZoom;
    const double y = extent.y > 0 ? room.y / extent.y : mostZoom;
    if (extent.x > 0 || extent.y > 0)
        zoom = std::clamp(std::min(x, y), leastZoom, mostZoom);
    centre = rectangle.min + extent * 0.5;
}

constexpr long long stay = 700; // milliseconds without a change
constexpr std::size_t most = 200;

void ViewHistory::leave(const View& view, long long now)
{
    if (now - last_ >= stay) {
        before_.push_back(view);
        after_.clear();
        if (before_.size() > most)
            before_.erase(before_.begin());
    }
    last_ = now;
}

static std::optional<View> turn(std::vector<View>& from, std::vector<View>& to, const View& present)
{
    if (from.empty())
        return std::nullopt;
    View view = from.back();
    from.pop_back();
    view.size = present.size;
    to.push_back(present);
    return view;
}

std::optional<View> ViewHistory::back(const View& present)
{
    return turn(before_, after_, present);
}
std::optional<View> ViewHistory::forth(const View& present)
{
    return turn(after_, before_, present);
}

constexpr double notch = 1.2;

void WheelZoom::turn(View& view, const Point& screen, double notches)
{
    if (!start_ || start_->screen != screen || start_->last != view)
        start_ = Start{view, screen, 0, view};
    const double before = start_->notches;
    start_->notches += notches;
    if (std::abs(start_->notches) < 1e-9)
        start_->notches = 0;
    view = start_->view;
    if (start_->notches != 0)
        view.zoomAt(screen, std::pow(notch, start_->notches));
    if (view == start_->last)
        start_->notches = before; // at the limit of zooming: turning back begins here
    start_->last = view;
}

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
