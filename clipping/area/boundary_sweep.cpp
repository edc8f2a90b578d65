// SPDX-License-Identifier: MIT
#include "clipping/area/boundary_sweep.h"

#include "clipping/area/along_edge.h"
#include "clipping/ieee_numbers.h"

namespace clipping {

bool BoundarySweep::Input::isApartFrom(const Segment& s) const
{
    const Window& box = region.grid.box();
    return region.edges.empty() || (s.a.x < box.min.x && s.b.x < box.min.x)
           || (s.a.x > box.max.x && s.b.x > box.max.x) || (s.a.y < box.min.y && s.b.y < box.min.y)
           || (s.a.y > box.max.y && s.b.y > box.max.y);
}

BoundarySweep::BoundarySweep(const PreparedRegion::Data& area, const PreparedRegion::Data& window)
    : area_{area, BothSides(area), false}, window_{window, BothSides(window), true}
{
}

void BoundarySweep::walkAreaEdge(const AreaEdge& edge) { walk(edge, area_, window_); }

void BoundarySweep::walkWindowEdge(const AreaEdge& edge) { walk(edge, window_, area_); }

void BoundarySweep::walk(const AreaEdge& edge, Input& own, Input& other)
{
    if (!other.region.keepsNone && other.isApartFrom(edge.segment)) {
        isWhole_ = isWhole_ && own.isWindow;
        return;
    }
    const SweptLine swept(edge.segment);
    stops_.clear(), along_.clear();
    other.sides.enter(swept);
    findStops(swept, edge, own, other);
    if (stops_.empty() && !other.sides.keepsLeft() && !other.sides.keepsRight()) {
        isWhole_ = isWhole_ && own.isWindow;
        return;
    }
    own.sides.enter(swept);
    findStops(swept, edge, own, own);
    sortStops(swept);
    passStops(swept, edge, own);
}

/// Finds the edges of an input that meet the segment between its ends, and those along it.
void BoundarySweep::findStops(const SweptLine& swept, const AreaEdge& edge, Input& own,
                              Input& input)
{
    if (input.isApartFrom(swept.segment))
        return;
    const auto comesFirst = [&](const AreaEdge& e) {
        return &input == &own ? &e < &edge : own.isWindow;
    };
    input.region.grid.trace(swept.segment, [&](std::size_t first, std::size_t last) {
        for (const std::uint32_t i : input.region.grid.edgesIn(first, last)) {
            const AreaEdge& e = input.region.edges[i];
            if (&e == &edge || swept.isApartFrom(e.segment))
                continue;
            const int from = swept.line.side(e.segment.a), to = swept.line.side(e.segment.b);
            if (from == 0 && to == 0) {
                if (comesFirst(e))
                    along_.push_back(&e);
            } else if (from != to) {
                const auto meeting = meetingOf(swept, e, from, to);
                if (meeting && meeting->place == Meeting::Place::Between)
                    stops_.push_back({*meeting, &input, 0});
            }
        }
    });
}

/// Orders the stops and removes repeated ones: an edge may be listed in several cells.
void BoundarySweep::sortStops(const SweptLine& swept)
{
    const auto edgeOf = [](const Stop& stop) { return stop.meeting.edge; };
    const auto comesFirst = [&](const Stop& p, const Stop& q) {
        const auto which = order(swept, p.meeting, q.meeting);
        return which != 0 ? which < 0 : std::less<>()(edgeOf(p), edgeOf(q));
    };
    std::ranges::sort(stops_, comesFirst);
    const auto repeated = std::ranges::unique(stops_, {}, edgeOf);
    stops_.erase(repeated.begin(), repeated.end());
    if (along_.empty())
        return;
    std::ranges::sort(along_, std::less<>());
    along_.erase(std::unique(along_.begin(), along_.end()), along_.end());
    for (const AreaEdge* e : along_) {
        const bool isForwards = comesBefore(swept.line, e->segment.a, e->segment.b);
        // Of a meeting at a vertex, `order` looks at that vertex alone.
        const Meeting atFrom{e, 0, 1, Meeting::Place::Between, 0, {}};
        const Meeting atTo{e, 1, 0, Meeting::Place::Between, 0, {}};
        for (const auto& [meeting, covers] :
             {std::pair(atFrom, isForwards ? 1 : -1), std::pair(atTo, isForwards ? -1 : 1)})
            if (comesBefore(swept.line, swept.segment.a, meeting.vertex())
                && comesBefore(swept.line, meeting.vertex(), swept.segment.b))
                stops_.push_back({meeting, nullptr, covers});
    }
    std::ranges::sort(stops_, comesFirst);
}

/// How many edges that come before this one lie along it just after its start.
int BoundarySweep::coversFrom(const SweptLine& swept)
{
    const glm::dvec2& start = swept.segment.a;
    return static_cast<int>(std::ranges::count_if(along_, [&](const AreaEdge* e) {
        const bool isForwards = comesBefore(swept.line, e->segment.a, e->segment.b);
        const auto& [from, to] = isForwards ? e->segment : Segment{e->segment.b, e->segment.a};
        return !comesBefore(swept.line, start, from) && comesBefore(swept.line, start, to);
    }));
}

/// Whether the result is on one side only of the edge, where the walk is.
bool BoundarySweep::isBoundary(const Input& own)
{
    const bool ofArea = area_.sides.keepsLeft() != area_.sides.keepsRight();
    const bool ofResult = (area_.sides.keepsLeft() && window_.sides.keepsLeft())
                          != (area_.sides.keepsRight() && window_.sides.keepsRight());
    isWhole_ = isWhole_ && (own.isWindow ? !ofResult : ofArea == ofResult);
    return ofResult;
}

void BoundarySweep::passStops(const SweptLine& swept, const AreaEdge& edge, const Input& own)
{
    int covers = coversFrom(swept);
    std::optional<Place> last = Place{swept.segment.a + 0.0, 0};
    const auto pieceTo = [&](const Place& here) { append(edge, own, *last, here); };
    std::size_t from = stops_.size(); // of the stops where the walk is
    const auto placeOf = [&](std::size_t i) {
        const glm::dvec2 at = pointOf(swept, stops_[i].meeting);
        return Place{at, shareAlong(swept.segment, at)};
    };
    for (std::size_t i = 0; i < stops_.size();) {
        const bool isPiece = covers == 0 && isBoundary(own);
        if (isPiece) {
            if (!last)
                last = placeOf(from);
            const Place here = placeOf(i);
            pieceTo(here);
            last = here;
        } else {
            last = std::nullopt;
        }
        from = i;
        do {
            const Stop& stop = stops_[i];
            covers += stop.covers;
            if (stop.input)
                stop.input->sides.turn(stop.meeting.edge->step, stop.meeting.left(),
                                       stop.meeting.right());
            ++i;
        } while (i < stops_.size() && !(order(swept, stops_[from].meeting, stops_[i].meeting) < 0));
    }
    if (covers != 0 || !isBoundary(own))
        return;
    if (!last)
        last = placeOf(from);
    pieceTo({swept.segment.b + 0.0, 1});
}

void BoundarySweep::append(const AreaEdge& edge, const Input& own, const Place& from,
                           const Place& to)
{
    isEmpty_ = false;
    if (from.at == to.at)
        return;
    // The result is on one side; it is to be the left one.
    const bool isReversed = !(area_.sides.keepsLeft() && window_.sides.keepsLeft());
    const Place &begin = isReversed ? to : from, &end = isReversed ? from : to;
    pieces_.push_back(
        {begin.at, end.at, &edge, isReversed, {edge.number, own.isWindow, begin.share, end.share}});
}

} // namespace clipping
