// SPDX-License-Identifier: MIT
#include "clipping/area/boundary_sweep.h"

#include "clipping/ieee_numbers.h"

namespace clipping {

bool BoundarySweep::Input::isApartFrom(const Segment& s) const
{
    const Window& box = region.grid.box();
    return region.edges.empty() || (s.a.x < box.min.x && s.b.x < box.min.x)
           || (s.a.x > box.max.x && s.b.x > box.max.x) || (s.a.y < box.min.y && s.b.y < box.min.y)
           || (s.a.y > box.max.y && s.b.y > box.max.y);
}

/// Brings the sides to the start of the edge, unless the edge before it has left them there.
void BoundarySweep::Input::enter(const SweptLine& swept, const AreaEdge& edge)
{
    if (entered != &edge)
        sides.enter(swept, near);
}

BoundarySweep::BoundarySweep(const PreparedRegion::Data& area, const PreparedRegion::Data& window)
    : area_{area, EdgesNear(area), BothSides(area), false}, window_{window, EdgesNear(window),
                                                                    BothSides(window), true}
{
}

void BoundarySweep::walk(const AreaEdge& edge, Input& own, Input& other)
{
    if (!other.region.keepsNone && other.isApartFrom(edge.segment)) {
        isWhole_ = isWhole_ && own.isWindow;
        return;
    }
    const SweptLine swept(edge.segment);
    const AreaEdge* const next = &edge + 1;
    const bool isFollowed = next < own.region.edges.data() + own.region.edges.size()
                            && next->segment.a == edge.segment.b;
    const auto afterEdge = [&](bool endIsFree) { return endIsFree && isFollowed ? next : nullptr; };
    stops_.clear();
    other.enter(swept, edge);
    other.entered = afterEdge(findStops(swept, edge, false, other));
    if (stops_.isEmpty() && !other.sides.keepsLeft() && !other.sides.keepsRight()) {
        isWhole_ = isWhole_ && own.isWindow;
        return;
    }
    own.enter(swept, edge);
    own.entered = afterEdge(findStops(swept, edge, true, own));
    stops_.sort(swept);
    passStops(swept, edge, own.isWindow);
}

/// Returns whether the edge's end is free of other edges of the input.
bool BoundarySweep::findStops(const SweptLine& swept, const AreaEdge& edge, bool isOwn,
                              Input& input)
{
    if (input.isApartFrom(swept.segment))
        return true;
    const AreaEdge* const none = input.region.edges.data();
    const AreaEdge* const all = none + input.region.edges.size();
    const AreaEdge* const before = isOwn ? &edge : input.isWindow ? none : all;
    return stops_.find(swept, {&edge, before}, input.near, input.isWindow);
}

/// Whether the result is on one side only of the edge, where the walk is.
bool BoundarySweep::isBoundary(bool isOfWindow)
{
    const bool ofArea = area_.sides.keepsLeft() != area_.sides.keepsRight();
    const bool ofResult = (area_.sides.keepsLeft() && window_.sides.keepsLeft())
                          != (area_.sides.keepsRight() && window_.sides.keepsRight());
    isWhole_ = isWhole_ && (isOfWindow ? !ofResult : ofArea == ofResult);
    return ofResult;
}

/// Passes all stops in one place. Returns the first one after it.
std::size_t BoundarySweep::pass(const SweptLine& swept, std::size_t first, int& covers)
{
    std::size_t i = first;
    do {
        const auto& [meeting, isOfWindow, change] = stops_[i];
        covers += change;
        if (change == 0)
            (isOfWindow ? window_ : area_)
                .sides.turn(meeting.edge->step, meeting.left(), meeting.right());
        ++i;
    } while (i < stops_.size() && stops_.areTogether(swept, first, i));
    return i;
}

void BoundarySweep::passStops(const SweptLine& swept, const AreaEdge& edge, bool isOfWindow)
{
    int covers = stops_.coversFrom(swept);
    std::optional<glm::dvec2> from = swept.segment.a + 0.0; // if already known; never -0
    std::size_t behind = 0;                                 // the last stop
    for (std::size_t i = 0;;) {
        const bool isPiece = covers == 0 && isBoundary(isOfWindow);
        const bool isLast = i == stops_.size();
        std::optional<glm::dvec2> to;
        if (isPiece) {
            to = isLast ? swept.segment.b + 0.0 : placeOf(swept, i);
            append(edge, isOfWindow, from ? *from : placeOf(swept, behind), *to);
        }
        if (isLast)
            return;
        from = to;
        behind = i;
        i = pass(swept, i, covers);
    }
}

void BoundarySweep::append(const AreaEdge& edge, bool isOfWindow, const glm::dvec2& from,
                           const glm::dvec2& to)
{
    isEmpty_ = false;
    if (from == to)
        return;
    // The result is on one side; it is to be the left one.
    const bool isReversed = !(area_.sides.keepsLeft() && window_.sides.keepsLeft());
    pieces_.push_back(
        {isReversed ? to : from, isReversed ? from : to, &edge, isOfWindow, isReversed});
}

} // namespace clipping
