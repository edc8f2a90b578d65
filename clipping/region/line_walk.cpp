// SPDX-License-Identifier: MIT
#include "clipping/region/line_walk.h"

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

void Meetings::sort(const SweptLine& swept)
{
    keepOnce(atStart, earlierEdge);
    keepOnce(atEnd, earlierEdge);
    keepOnce(between, [&](const Meeting& p, const Meeting& q) {
        const auto which = order(swept, p, q);
        return which != 0 ? which < 0 : earlierEdge(p, q);
    });
}

LineWalk::LineWalk(const PreparedRegion::Data& region)
    : region_(region), beside_(region.rules.size())
{
}

std::span<const RegionPiece> LineWalk::piecesOf(const SweptLine& swept, const Meetings& meetings,
                                                std::uint32_t source)
{
    begin();
    walk(swept, meetings, source);
    leave();
    return pieces_;
}

void LineWalk::turn(std::uint32_t step, int left, int right)
{
    Beside& beside = beside_[step];
    beside.left += left, beside.right += right;
    if (!beside.isTouched) {
        beside.isTouched = true;
        touched_.push_back(step);
    }
}

void LineWalk::update(std::uint32_t step)
{
    Beside& beside = beside_[step];
    const bool isIn = region_.fills(step, beside.left) || region_.fills(step, beside.right);
    if (isIn != beside.isIn)
        RegionFold::flip(state_, step);
    beside.isIn = isIn;
}

/// Finds which areas the walk starts in.
void LineWalk::begin()
{
    pieces_.clear();
    state_ = region_.fold.inNone();
    for (const std::uint32_t step : touched_)
        update(step);
}

void LineWalk::leave()
{
    for (const std::uint32_t step : touched_)
        beside_[step] = {};
    touched_.clear();
}

/// Passes the edges that meet the segment in one point. Returns the number of the first one whose
/// area is entered or left; of the first one if there is none.
std::uint32_t LineWalk::pass(std::span<const Meeting> meetings)
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

/// Whether the point of these meetings alone is kept. The walk is just behind it.
bool LineWalk::keepsPoint(std::span<const Meeting> meetings) const
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

void LineWalk::walk(const SweptLine& swept, const Meetings& meetings, std::uint32_t source)
{
    const auto& [atStart, between, atEnd] = meetings;
    const auto& [a, b] = swept.segment;
    if (a == b) { // nothing is just behind it
        if (keepsPoint(atStart))
            append({a, 0}, {b, 0}, source);
        return;
    }
    bool kept = keeps();
    Cut from{a, 0};
    if (!kept && !atStart.empty() && keepsPoint(atStart))
        append(from, {a, atStart.front().edge->number}, source);
    for (std::span<const Meeting> rest = between; !rest.empty();) {
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
    } else if (!atEnd.empty()) {
        pass(atEnd);
        if (keepsPoint(atEnd))
            append({b, atEnd.front().edge->number}, {b, 0}, source);
    }
}

} // namespace clipping
