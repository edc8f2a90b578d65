// SPDX-License-Identifier: MIT
#include "clipping/area/edge_stops.h"

#include "clipping/area/along_edge.h"
#include "clipping/ieee_numbers.h"

#include <functional>
#include <limits>

namespace clipping {

using Place = Meeting::Place;

bool EdgeStops::find(const SweptLine& swept, const Rank& rank, EdgesNear& near, bool isOfWindow)
{
    bool endIsFree = true;
    near.forEach(swept.segment, [&](const AreaEdge& edge) {
        if (&edge == rank.edge || swept.isApartFrom(edge.segment))
            return;
        const int from = swept.line.side(edge.segment.a), to = swept.line.side(edge.segment.b);
        if (from == 0 && to == 0) {
            endIsFree = false;
            if (std::less<>()(&edge, rank.allBefore))
                along_.push_back(&edge);
        }
        if (from == to)
            return;
        const auto meeting = meetingOf(swept, edge, from, to);
        if (meeting && meeting->place == Place::Between)
            stops_.push_back({*meeting, isOfWindow, 0});
        else if (meeting && meeting->place == Place::End && &edge != rank.edge + 1)
            endIsFree = false;
    });
    return endIsFree;
}

bool EdgeStops::comesBefore(const SweptLine& swept, const Key& p, const Key& q) const
{
    if (p.high < q.low || q.high < p.low)
        return p.high < q.low;
    const Meeting &m = stops_[p.stop].meeting, &n = stops_[q.stop].meeting;
    const auto which = order(swept, m, n);
    return which != 0 ? which < 0 : std::less<>()(m.edge, n.edge);
}

void EdgeStops::addKeys()
{
    constexpr double unknown = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < stops_.size(); ++i) {
        const auto& [meeting, isOfWindow, covers] = stops_[i];
        const auto& [share, error] = meeting.share;
        const bool isKnown = !meeting.atVertex() && error < unknown;
        keys_.push_back({isKnown ? share - error : -unknown, isKnown ? share + error : unknown,
                         static_cast<std::uint32_t>(i)});
    }
}

void EdgeStops::sort(const SweptLine& swept)
{
    const auto before = [&](const Key& p, const Key& q) { return comesBefore(swept, p, q); };
    const auto edgeOf = [&](const Key& key) { return stops_[key.stop].meeting.edge; };
    addKeys();
    std::ranges::sort(keys_, before);
    const auto repeated = std::ranges::unique(keys_, {}, edgeOf); // listed in several cells
    keys_.erase(repeated.begin(), repeated.end());
    if (along_.empty())
        return;
    addCovers(swept);
    std::ranges::sort(keys_, before);
}

/// Adds the ends, between those of the edge, of the edges along it.
void EdgeStops::addCovers(const SweptLine& swept)
{
    std::ranges::sort(along_, std::less<>());
    along_.erase(std::unique(along_.begin(), along_.end()), along_.end());
    const auto& [start, end] = swept.segment;
    for (const AreaEdge* edge : along_) {
        const int onset =
            clipping::comesBefore(swept.line, edge->segment.a, edge->segment.b) ? 1 : -1;
        // Of a meeting at a vertex, `order` looks at that vertex alone.
        for (const auto& [meeting, covers] :
             {std::pair(Meeting{edge, 0, 1, Place::Between, 0, {}}, onset),
              std::pair(Meeting{edge, 1, 0, Place::Between, 0, {}}, -onset)})
            if (clipping::comesBefore(swept.line, start, meeting.vertex())
                && clipping::comesBefore(swept.line, meeting.vertex(), end)) {
                constexpr double unknown = std::numeric_limits<double>::infinity();
                keys_.push_back({-unknown, unknown, static_cast<std::uint32_t>(stops_.size())});
                stops_.push_back({meeting, false, covers});
            }
    }
}

int EdgeStops::coversFrom(const SweptLine& swept) const
{
    const glm::dvec2& start = swept.segment.a;
    return static_cast<int>(std::ranges::count_if(along_, [&](const AreaEdge* edge) {
        const auto& [a, b] = edge->segment;
        const bool isForwards = clipping::comesBefore(swept.line, a, b);
        const glm::dvec2 &from = isForwards ? a : b, &to = isForwards ? b : a;
        return !clipping::comesBefore(swept.line, start, from)
               && clipping::comesBefore(swept.line, start, to);
    }));
}

} // namespace clipping
