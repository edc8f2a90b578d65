// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/polyline_builder.h"

#include "app/view/caps.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace app {

constexpr double closest = 0.25;             // pixels between the points of a polyline
constexpr double shortestDrawnPattern = 1.5; // pixels; finer dashes are drawn solid
constexpr std::size_t recentPolylines = 4096;

PolylineBuilder::PolylineBuilder(DrawList& drawList, const View& view)
    : drawList_(drawList), view_(view), recent_(recentPolylines)
{
}

void PolylineBuilder::setDashes(std::vector<double> pattern)
{
    end();
    pattern_ = std::move(pattern);
}

void PolylineBuilder::begin(const SeenPart& part, double phase)
{
    openAt_ = std::uint32_t(drawList_.points.size());
    drawList_.points.push_back(onScreen(part.segment.a));
    open_ = Open{part.segment.a, std::nullopt, phase, !part.cutA};
}

void PolylineBuilder::proceed(const Point& to)
{
    const QPointF p = onScreen(to), step = p - drawList_.points.back();
    open_->last = to;
    if (std::abs(step.x()) < closest && std::abs(step.y()) < closest) {
        open_->unsaid = p;
    } else {
        drawList_.points.push_back(p);
        open_->unsaid.reset();
    }
}

void PolylineBuilder::finish(bool capAtEnd)
{
    if (open_->unsaid)
        drawList_.points.push_back(*open_->unsaid);
    const auto count = std::uint32_t(drawList_.points.size()) - openAt_;
    const bool closed = count > 3 && drawList_.points[openAt_] == drawList_.points.back()
                        && open_->capAtStart && capAtEnd;
    if (pattern_.empty())
        push({openAt_, count, closed, open_->capAtStart, capAtEnd});
    else
        finishDashed();
    open_.reset();
}

// All dashes have caps, also where a cut ends one, as in an exported drawing (cut/runs.h).
void PolylineBuilder::finishDashed()
{
    const std::vector<QPointF> line(drawList_.points.begin() + openAt_, drawList_.points.end());
    drawList_.points.resize(openAt_);
    const auto all = dashes(line, pattern_, open_->phase * view_.zoom, shortestDrawnPattern);
    for (const auto& dash : all) {
        const auto first = std::uint32_t(drawList_.points.size());
        drawList_.points.insert(drawList_.points.end(), dash.begin(), dash.end());
        push({first, std::uint32_t(dash.size()), false, true, true});
    }
}

// QPointF's own == accepts points that are only nearly equal.
static bool isSamePoint(const QPointF& p, const QPointF& q)
{
    return p.x() == q.x() && p.y() == q.y();
}

// Drops opaque polylines that repeat a recent one. Painting a polyline takes long where it covers
// many pixels, and a file may contain the same line a hundred thousand times. Translucent strokes
// add up, so all of them are kept.
void PolylineBuilder::push(const Polyline& polyline)
{
    if (drawList_.commands.back().stroke->colour.alpha == 255 && liesOnAnother(polyline)) {
        drawList_.points.resize(polyline.first);
        return;
    }
    drawList_.polylines.push_back(polyline);
    ++drawList_.commands.back().polylines;
}

// Whether the polyline equals, exactly, one of the latest polylines of the same draw command.
bool PolylineBuilder::liesOnAnother(const Polyline& polyline)
{
    const auto points = drawList_.pointsOf(polyline);
    std::uint64_t hash = 0;
    for (const QPointF& p : points)
        for (const double coordinate : {p.x(), p.y()})
            hash = (std::rotl(hash, 5) ^ std::bit_cast<std::uint64_t>(coordinate))
                   * 0x9e3779b97f4a7c15;
    std::uint32_t& slot = recent_[(hash >> 32) % recentPolylines];
    const std::uint32_t earlier = std::exchange(slot, std::uint32_t(drawList_.polylines.size()));
    if (earlier < drawList_.commands.back().firstPolyline || earlier >= drawList_.polylines.size())
        return false;
    const Polyline& other = drawList_.polylines[earlier];
    const bool same = other.closed == polyline.closed && other.capAtStart == polyline.capAtStart
                      && other.capAtEnd == polyline.capAtEnd
                      && std::ranges::equal(drawList_.pointsOf(other), points, isSamePoint);
    if (same)
        slot = earlier;
    return same;
}

} // namespace app
