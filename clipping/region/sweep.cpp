// SPDX-License-Identifier: MIT
#include "clipping/region/sweep.h"

#include "clipping/ieee_numbers.h"

namespace clipping {
namespace {

bool sameEdge(const Meeting& p, const Meeting& q) { return p.edge == q.edge; }
bool earlierEdge(const Meeting& p, const Meeting& q) { return p.edge < q.edge; }

/// Sorts meetings and removes repeated ones: an edge may be listed in several cells.
template <class Earlier>
void keepOnce(std::vector<Meeting>& meetings, Earlier earlier)
{
    if (meetings.size() < 2)
        return;
    std::ranges::sort(meetings, earlier);
    meetings.erase(std::unique(meetings.begin(), meetings.end(), sameEdge), meetings.end());
}

/// The meetings of the first area among these, which are ordered by edge.
std::span<const Meeting> ofFirstArea(std::span<const Meeting> meetings)
{
    const auto end = std::ranges::find_if(meetings, [&](const Meeting& meeting) {
        return meeting.edge->step != meetings.front().edge->step;
    });
    return {meetings.begin(), end};
}

} // namespace

LineSweep::LineSweep(const PreparedRegion::Data& region)
    : region_(region), beside_(region.rules.size())
{
}

std::span<const RegionPiece> LineSweep::piecesOf(const Segment& segment, std::uint32_t source)
{
    const SweptLine swept(segment);
    pieces_.clear();
    if (findMeetings(swept)) {
        sortMeetings(swept);
        enterAt(swept);
        walk(swept, source);
        leave();
    } else if (contains(region_.grid.box(), segment.a)
                   ? region_.keepsReference[region_.grid.cellOf(segment.a)]
                   : region_.keepsNone) {
        append({segment.a, 0}, {segment.b, 0}, source);
    }
    return pieces_;
}

/// Whether there may be an edge between the segment and the reference point of its start.
bool LineSweep::findMeetings(const SweptLine& swept)
{
    atStart_.clear(), between_.clear(), atEnd_.clear();
    bool any = false;
    region_.grid.trace(swept.segment, [&](std::size_t first, std::size_t last) {
        for (const std::uint32_t edge : region_.grid.edgesIn(first, last)) {
            any = true;
            if (const auto meeting = meetingOf(swept, region_.edges[edge]))
                (meeting->place == Meeting::Place::Start ? atStart_
                 : meeting->place == Meeting::Place::End ? atEnd_
                                                         : between_)
                    .push_back(*meeting);
        }
    });
    return any;
}

void LineSweep::sortMeetings(const SweptLine& swept)
{
    keepOnce(atStart_, earlierEdge);
    keepOnce(atEnd_, earlierEdge);
    keepOnce(between_, [&](const Meeting& p, const Meeting& q) {
        const auto which = order(swept, p, q);
        return which != 0 ? which < 0 : earlierEdge(p, q);
    });
}

void LineSweep::turn(std::uint32_t step, int left, int right)
{
    Beside& beside = beside_[step];
    beside.left += left, beside.right += right;
    if (!beside.isTouched) {
        beside.isTouched = true;
        touched_.push_back(step);
    }
}

void LineSweep::update(std::uint32_t step)
{
    Beside& beside = beside_[step];
    const bool isIn = region_.fills(step, beside.left) || region_.fills(step, beside.right);
    if (isIn != beside.isIn)
        RegionFold::flip(state_, step);
    beside.isIn = isIn;
}

/// Counts the windings beside the start of the segment.
void LineSweep::enterAt(const SweptLine& swept)
{
    state_ = region_.fold.inNone();
    const SearchGrid& grid = region_.grid;
    if (!contains(grid.box(), swept.segment.a))
        return;
    const std::size_t cell = grid.cellOf(swept.segment.a);
    for (const auto& [step, winding] : grid.windingsIn(cell))
        turn(step, winding, winding);
    const Reference reference = grid.reference(cell);
    const BesideStart left{swept.line, 1}, right{swept.line, -1};
    for (const std::uint32_t i : grid.edgesIn(cell, cell)) {
        const AreaEdge& edge = region_.edges[i];
        const int ofLeft = windingStep(edge.segment, reference, left);
        const int ofRight = windingStep(edge.segment, reference, right);
        if (ofLeft != 0 || ofRight != 0)
            turn(edge.step, ofLeft, ofRight);
    }
    for (const std::uint32_t step : touched_)
        update(step);
}

void LineSweep::leave()
{
    for (const std::uint32_t step : touched_)
        beside_[step] = {};
    touched_.clear();
}

/// Passes the edges that meet the segment in one point. Returns the number of the first one whose
/// area is entered or left; of the first one if there is none.
std::uint32_t LineSweep::pass(std::span<const Meeting> meetings)
{
    std::uint32_t first = 0;
    const std::uint32_t any = meetings.front().edge->number;
    while (!meetings.empty()) {
        const auto same = ofFirstArea(meetings);
        const std::uint32_t step = same.front().edge->step;
        for (const Meeting& meeting : same)
            turn(step, meeting.left(), meeting.right());
        const bool wasIn = beside_[step].isIn;
        update(step);
        if (first == 0 && wasIn != beside_[step].isIn)
            first = same.front().edge->number;
        meetings = meetings.subspan(same.size());
    }
    return first != 0 ? first : any;
}

/// Whether the point of these meetings alone is kept. The sweep is just behind it.
bool LineSweep::keepsPoint(std::span<const Meeting> meetings) const
{
    RegionFold::Words state = state_;
    while (!meetings.empty()) {
        const auto same = ofFirstArea(meetings);
        const std::uint32_t step = same.front().edge->step;
        const auto& [left, right, isIn, isTouched] = beside_[step];
        const auto fills = [&, step = step](int winding) { return region_.fills(step, winding); };
        if (isFilledAround(same, left, right, fills) != isIn)
            RegionFold::flip(state, step);
        meetings = meetings.subspan(same.size());
    }
    return region_.fold.keeps(state);
}

void LineSweep::walk(const SweptLine& swept, std::uint32_t source)
{
    const auto& [a, b] = swept.segment;
    if (a == b) { // nothing is just behind it
        if (keepsPoint(atStart_))
            append({a, 0}, {b, 0}, source);
        return;
    }
    bool kept = keeps();
    Cut from{a, 0};
    if (!kept && !atStart_.empty() && keepsPoint(atStart_))
        append(from, {a, atStart_.front().edge->number}, source);
    for (std::span<const Meeting> rest = between_; !rest.empty();) {
        const auto end = std::ranges::find_if(
            rest, [&](const Meeting& meeting) { return order(swept, rest.front(), meeting) < 0; });
        const std::span<const Meeting> here(rest.begin(), end);
        rest = rest.subspan(here.size());
        const bool wasKept = kept;
        const std::uint32_t edge = pass(here);
        kept = keeps();
        if (wasKept && kept)
            continue;
        if (!wasKept && !kept && !keepsPoint(here))
            continue;
        const Cut cut{pointOf(swept, here.front()), edge};
        if (kept)
            from = cut;
        else
            append(wasKept ? from : cut, cut, source);
    }
    if (kept) {
        append(from, {b, 0}, source);
    } else if (!atEnd_.empty()) {
        pass(atEnd_);
        if (keepsPoint(atEnd_))
            append({b, atEnd_.front().edge->number}, {b, 0}, source);
    }
}

} // namespace clipping
