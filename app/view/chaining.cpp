// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/chaining.h"

#include "app/view/dashes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace app {

constexpr double closest = 0.25;        // pixels between the points of a polyline
constexpr double shortestPattern = 1.5; // pixels; finer dashes are drawn solid
constexpr std::size_t recentChains = 4096;

Chaining::Chaining(Plate& plate, const View& view)
    : plate_(plate), view_(view), recent_(recentChains)
{
}

void Chaining::setDashes(std::vector<double> pattern)
{
    end();
    pattern_ = std::move(pattern);
}

void Chaining::begin(const SeenPart& part, double phase)
{
    openAt_ = std::uint32_t(plate_.points.size());
    plate_.points.push_back(onScreen(part.segment.a));
    open_ = Open{part.segment.a, std::nullopt, phase, !part.cutA};
}

void Chaining::proceed(const Point& to)
{
    const QPointF p = onScreen(to), step = p - plate_.points.back();
    open_->last = to;
    if (std::abs(step.x()) < closest && std::abs(step.y()) < closest) {
        open_->unsaid = p;
    } else {
        plate_.points.push_back(p);
        open_->unsaid.reset();
    }
}

void Chaining::finish(bool capAtEnd)
{
    if (open_->unsaid)
        plate_.points.push_back(*open_->unsaid);
    const auto count = std::uint32_t(plate_.points.size()) - openAt_;
    const bool closed = count > 3 && plate_.points[openAt_] == plate_.points.back()
                        && open_->capAtStart && capAtEnd;
    if (pattern_.empty())
        push({openAt_, count, closed, open_->capAtStart, capAtEnd});
    else
        finishDashed(capAtEnd);
    open_.reset();
}

void Chaining::finishDashed(bool capAtEnd)
{
    const std::vector<QPointF> line(plate_.points.begin() + openAt_, plate_.points.end());
    plate_.points.resize(openAt_);
    const auto all = dashes(line, pattern_, open_->phase * view_.zoom, shortestPattern);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto first = std::uint32_t(plate_.points.size());
        plate_.points.insert(plate_.points.end(), all[i].begin(), all[i].end());
        const bool atStart = all[i].front() == line.front(), atEnd = all[i].back() == line.back();
        push({first, std::uint32_t(all[i].size()), false, !atStart || open_->capAtStart,
              !atEnd || capAtEnd});
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
void Chaining::push(const Chain& chain)
{
    if (plate_.coats.back().stroke->colour.alpha == 255 && liesOnAnother(chain)) {
        plate_.points.resize(chain.first);
        return;
    }
    plate_.chains.push_back(chain);
    ++plate_.coats.back().chains;
}

// Whether the polyline equals, exactly, one of the latest polylines of the same draw command.
bool Chaining::liesOnAnother(const Chain& chain)
{
    const auto points = plate_.pointsOf(chain);
    std::uint64_t hash = 0;
    for (const QPointF& p : points)
        for (const double coordinate : {p.x(), p.y()})
            hash = (std::rotl(hash, 5) ^ std::bit_cast<std::uint64_t>(coordinate))
                   * 0x9e3779b97f4a7c15;
    std::uint32_t& slot = recent_[(hash >> 32) % recentChains];
    const std::uint32_t earlier = std::exchange(slot, std::uint32_t(plate_.chains.size()));
    if (earlier < plate_.coats.back().firstChain || earlier >= plate_.chains.size())
        return false;
    const Chain& other = plate_.chains[earlier];
    const bool same = other.closed == chain.closed && other.capAtStart == chain.capAtStart
                      && other.capAtEnd == chain.capAtEnd
                      && std::ranges::equal(plate_.pointsOf(other), points, isSamePoint);
    if (same)
        slot = earlier;
    return same;
}

} // namespace app
