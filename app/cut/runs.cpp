// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/runs.h"

#include "app/cut/cut_ends.h"
#include "app/cut/true_curve.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

using clipping::Edge;

using End = CurvePoint; // where a run begins or ends

// std::hypot: squares could overflow.
double distance(const Point& a, const Point& b) { return std::hypot(b.x - a.x, b.y - a.y); }

double levelOf(Edge edge, const clipping::Window& window)
{
    return edge == Edge::Left     ? window.min.x
           : edge == Edge::Right  ? window.max.x
           : edge == Edge::Bottom ? window.min.y
                                  : window.max.y;
}

// A window on whose edge the point lies. A single window is returned in any case, as the published
// forms may miss the edge.
const clipping::Window* windowAt(const ClipRegion& region, const Point& p, Edge edge)
{
    const int other = edge == Edge::Left || edge == Edge::Right ? 1 : 0;
    for (const auto& step : region.steps)
        if (p[1 - other] == levelOf(edge, step.box) && p[other] >= step.box.min[other]
            && p[other] <= step.box.max[other])
            return &step.box;
    return region.steps.size() == 1 ? &region.steps.front().box : nullptr;
}

std::optional<End> endAtBorder(const TrueCurve& curve, const Chord& chord, const Point& cut,
                               const ClipRegion& region)
{
    const auto edge = borderAt(region, chord.segment, cut);
    return edge ? crossing(curve, chord, *edge) : std::nullopt;
}

// The point at which the curve itself crosses the edge's line, by bisection within the chord's
// interval. If the curve does not cross it (the chord cuts a corner that the curve misses), the
// chord's own cut.
End refined(const TrueCurve& curve, const Chord& chord, const Point& cut, Edge edge,
            const ClipRegion& region)
{
    const Point along = chord.segment.b - chord.segment.a;
    const int longer = std::abs(along.x) > std::abs(along.y) ? 0 : 1; // no squares: no overflow
    const double s =
        along[longer] != 0 ? (cut[longer] - chord.segment.a[longer]) / along[longer] : 0.0;
    const End onChord{chord.t0 + (chord.t1 - chord.t0) * std::clamp(s, 0.0, 1.0), cut};
    if (edge == borderEdge)
        return endAtBorder(curve, chord, cut, region).value_or(onChord);
    if (edge == Edge::NoEdge)
        return onChord;
    const int axis = edge == Edge::Left || edge == Edge::Right ? 0 : 1;
    const auto t = passage(curve, chord, [&](const Point& p) { return p[axis] > cut[axis]; });
    if (!t)
        return onChord;
    Point point = curve.at(*t);
    if (const clipping::Window* window = windowAt(region, cut, edge))
        point = glm::clamp(point, window->min, window->max);
    point[axis] = cut[axis];
    return {*t, point};
}

class Runs {
public:
    Runs(const Subpath& path, std::span<const Chord> chords, const ClipRegion& region,
         const CurvedBorder& border)
        : path_(path), chords_(chords), region_(region), border_(border)
    {
    }

    void add(const KeptPart& part)
    {
        const Chord& chord = chords_[part.chord];
        const bool curve = isCurve(path_, chord.pathSegment);
        End begin{chord.t0, part.segment.a}, end{chord.t1, part.segment.b};
        if (begin.point != chord.segment.a)
            begin = cutAt(chord, begin, part.edgeA);
        if (end.point != chord.segment.b)
            end = cutAt(chord, end, part.edgeB);
        if (!curve && begin.point == end.point && part.segment.a != part.segment.b)
            return; // it is beside the border itself
        const bool fresh = begin.point != chord.segment.a, over = end.point != chord.segment.b;
        if (fresh || !open_ || part.chord != next_) {
            finishCurve();
            runs_.push_back({{begin.point, {}, false}, lengthBefore(part)});
        }
        if (curve)
            extendCurve(chord.pathSegment, begin, end);
        else if (finishCurve(); part.segment.a != part.segment.b || !path_.segments.empty())
            extendLine(chord, end.point);
        open_ = !over;
        next_ = part.chord + 1;
    }

    std::vector<Run> take(bool join)
    {
        finishCurve();
        if (join && open_ && next_ == chords_.size() && runs_.size() > 1
            && runs_.front().path.start == chords_.front().segment.a && startsAtChord0_) {
            auto& first = runs_.front().path.segments;
            auto& last = runs_.back().path.segments;
            last.insert(last.end(), first.begin(), first.end());
            runs_.erase(runs_.begin());
        }
        return std::move(runs_);
    }

    void noteFirst(const KeptPart& part)
    {
        startsAtChord0_ = part.chord == 0 && part.segment.a == chords_[0].segment.a;
    }

private:
    // A cut, moved to where the curve or the border itself is met.
    End cutAt(const Chord& chord, const End& cut, Edge edge)
    {
        if (!isCurve(path_, chord.pathSegment)) {
            const auto met = border_.meeting(chord.segment, cut.point);
            return met ? End{cut.t, met->point} : cut;
        }
        const TrueCurve& curve = curveAt(chord.pathSegment);
        if (const auto met = border_.meeting(curve, chord, cut.point))
            return {met->t, met->point};
        return refined(curve, chord, cut.point, edge, region_);
    }

    // The chords of a line that runs along a border are one line again.
    void extendLine(const Chord& chord, const Point& end)
    {
        auto& segments = runs_.back().path.segments;
        if (chord.t0 > 0 && !segments.empty())
            segments.back() = {end};
        else
            segments.push_back({end});
    }

    const TrueCurve& curveAt(std::size_t segment)
    {
        if (!curve_ || curve_->first != segment)
            curve_.emplace(segment, border_.curveAt(path_, segment));
        return curve_->second;
    }

    // Collects the chords of one curve, so that they become one curve again.
    void extendCurve(std::size_t segment, const End& begin, const End& end)
    {
        if (curveSegment_ != segment || begin.t != curveEnd_.t)
            finishCurve();
        if (curveSegment_ == path_.segments.size() + 1) {
            curveSegment_ = segment;
            curveBegin_ = begin;
        }
        curveEnd_ = end;
    }

    void finishCurve()
    {
        const std::size_t none = path_.segments.size() + 1;
        if (curveSegment_ == none)
            return;
        if (curveBegin_.t > curveEnd_.t) { // a piece at a polygon, of which the curve has nothing
            runs_.back().path.segments.push_back({curveEnd_.point});
            curveSegment_ = none;
            return;
        }
        curveAt(curveSegment_)
            .append(runs_.back().path.segments, curveBegin_.t, curveEnd_.t, curveBegin_.point,
                    curveEnd_.point);
        curveSegment_ = none;
    }

    double lengthBefore(const KeptPart& part)
    {
        for (; measured_ < part.chord; ++measured_) {
            const auto& s = chords_[measured_].segment;
            length_ += distance(s.a, s.b);
        }
        return length_ + distance(chords_[part.chord].segment.a, part.segment.a);
    }

    const Subpath& path_;
    std::span<const Chord> chords_;
    const ClipRegion& region_;
    const CurvedBorder& border_;
    std::vector<Run> runs_;
    bool open_ = false; ///< at its chord's end: chord `next_` may continue the run
    bool startsAtChord0_ = false;
    std::size_t next_ = 0;
    std::size_t curveSegment_ = path_.segments.size() + 1; ///< the initial value: no curve
    End curveBegin_{}, curveEnd_{};
    std::optional<std::pair<std::size_t, TrueCurve>> curve_; ///< the last one, by its segment
    std::size_t measured_ = 0;
    double length_ = 0;
};

bool isWhole(std::span<const Chord> chords, std::span<const KeptPart> parts)
{
    return std::ranges::equal(chords, parts, [](const Chord& chord, const KeptPart& part) {
        return chord.segment == part.segment;
    });
}

} // namespace

std::vector<Run> joinRuns(const Subpath& path, std::span<const Chord> chords,
                          std::span<const KeptPart> parts, const ClipRegion& region,
                          ClosedStart closedStart, const CurvedBorder& border)
{
    if (parts.empty())
        return {};
    if (isWhole(chords, parts))
        return {{path, 0}};
    Runs runs(path, chords, region, border);
    runs.noteFirst(parts.front());
    for (const KeptPart& part : parts)
        runs.add(part);
    return runs.take(path.closed && closedStart == ClosedStart::Join);
}

std::vector<Object> objectsOfRuns(Object object, std::vector<Run> runs)
{
    object.particulars.recipe = {};
    if (object.style.dashes.empty()) // dashes would shrink without their caps, and dots vanish
        object.style.cap = Cap::Butt;
    std::vector<Subpath> all;
    std::vector<Object> objects;
    const double offset = object.style.dashOffset;
    for (Run& run : runs) {
        if (object.style.dashes.empty()) {
            all.push_back(std::move(run.path));
            continue;
        }
        object.path = Path({&run.path, 1});
        object.style.dashOffset = offset + run.before;
        objects.push_back(object);
        object.particulars = {};
    }
    if (!all.empty()) {
        object.path = Path(all);
        objects.push_back(std::move(object));
    }
    return objects;
}

} // namespace app
