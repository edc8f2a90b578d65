// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/covering.h"

#include "app/scene/region.h"

#include <glm/common.hpp>

#include <algorithm>
#include <limits>

namespace app {
namespace {

using clipping::Segment;
using clipping::Window;

constexpr std::size_t piecesAtOnce = 256;

Window boxOf(std::span<const Point> points)
{
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Window box{Point(infinite), Point(-infinite)};
    for (const Point& p : points)
        box = {glm::min(box.min, p), glm::max(box.max, p)};
    return box;
}

Window boxOf(const Segment& line) { return {glm::min(line.a, line.b), glm::max(line.a, line.b)}; }

bool meet(const Window& a, const Window& b)
{
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

// Whether p comes before q along the line. Both are rounded points of it, and so in the line's
// order on each axis.
bool comesBefore(const Point& p, const Point& q, const Segment& line)
{
    for (const glm::length_t axis : {0, 1})
        if (p[axis] != q[axis])
            return (p[axis] < q[axis]) == (line.a[axis] < line.b[axis]);
    return false;
}

std::uint32_t cutAt(bool a, bool b)
{
    constexpr auto none = clipping::Edge::NoEdge;
    return clipping::cutAt(a ? borderEdge : none, b ? borderEdge : none);
}

} // namespace

Covering::Covering(std::vector<clipping::Area> areas, const std::stop_token& stop)
    : areas_(std::move(areas)), stop_(stop), prepared_(areas_.size()), pieces_(piecesAtOnce)
{
    for (const clipping::Area& area : areas_)
        boxes_.push_back(boxOf(area.points));
    index_ = BoxIndex(boxes_);
}

const clipping::PreparedRegion& Covering::prepared(std::uint32_t area)
{
    if (!prepared_[area])
        prepared_[area].emplace(clipping::Region{{{areas_[area]}}});
    return *prepared_[area];
}

std::span<const clipping::Clipped> Covering::visible(std::span<const Chord> chords,
                                                     std::size_t first)
{
    visible_.clear();
    covered_.clear();
    open_.clear();
    chordBoxes_.clear();
    gone_.assign(chords.size(), false);
    above_.clear();
    for (const Chord& chord : chords) {
        open_.push_back(std::uint32_t(open_.size()));
        chordBoxes_.push_back(boxOf(chord.segment));
    }
    std::vector<Point> corners;
    for (const Window& box : chordBoxes_)
        corners.insert(corners.end(), {box.min, box.max});
    index_.meeting(boxOf(corners), std::uint32_t(first),
                   [&](std::uint32_t area) { above_.push_back(area); });
    for (const std::uint32_t area : above_)
        if (!open_.empty() && !stop_.stop_requested())
            coverBy(area, chords);

    std::ranges::sort(covered_, [&](const Covered& a, const Covered& b) {
        return a.chord != b.chord ? a.chord < b.chord
                                  : comesBefore(a.from, b.from, chords[a.chord].segment);
    });
    std::span<const Covered> left(covered_);
    for (std::uint32_t chord = 0; chord < chords.size(); ++chord) {
        const auto end = std::ranges::find_if(
            left, [&](const Covered& covered) { return covered.chord != chord; });
        const auto own = left.first(std::size_t(end - left.begin()));
        left = left.subspan(own.size());
        if (!gone_[chord])
            addVisible(chord, chords[chord].segment, own);
    }
    return visible_;
}

void Covering::coverBy(std::uint32_t area, std::span<const Chord> chords)
{
    asked_.clear();
    lines_.clear();
    for (const std::uint32_t chord : open_)
        if (meet(chordBoxes_[chord], boxes_[area])) {
            asked_.push_back(chord);
            lines_.push_back(chords[chord].segment);
        }
    bool anyGone = false;
    for (clipping::RegionProgress at; at.segment < lines_.size() && !stop_.stop_requested();) {
        at = clipping::clipAll(lines_, prepared(area), pieces_, at);
        for (const auto& piece : std::span(pieces_).first(at.written)) {
            take(piece, chords);
            anyGone = anyGone || gone_[asked_[piece.source]];
        }
    }
    if (anyGone)
        std::erase_if(open_, [&](std::uint32_t chord) { return gone_[chord]; });
}

void Covering::take(const clipping::RegionPiece& piece, std::span<const Chord> chords)
{
    const std::uint32_t chord = asked_[piece.source];
    const auto& [a, b] = piece.segment;
    if (piece.segment == chords[chord].segment)
        gone_[chord] = true;
    else if (a != b) // a contact covers nothing
        covered_.push_back({chord, a, b});
}

void Covering::addVisible(std::uint32_t chord, const Segment& line,
                          std::span<const Covered> covered)
{
    Point from = line.a;
    bool cut = false;
    for (const Covered& part : covered) {
        if (comesBefore(from, part.from, line))
            visible_.push_back({{from, part.from}, chord, cutAt(cut, true)});
        if (comesBefore(from, part.to, line)) {
            from = part.to;
            cut = true;
        }
    }
    if (!cut || comesBefore(from, line.b, line))
        visible_.push_back({{from, line.b}, chord, cutAt(cut, false)});
}

} // namespace app
