// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/region.h"
#include "clipping/outside.h"

#include <QVarLengthArray>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

namespace app {
namespace {

using clipping::Clipped;
using clipping::Edge;
using clipping::Segment;
using Pieces = std::span<const std::optional<Clipped>>; ///< of one line, one for each step

bool isFinite(const Segment& s)
{
    return std::isfinite(s.a.x) && std::isfinite(s.a.y) && std::isfinite(s.b.x)
           && std::isfinite(s.b.y);
}

bool isSeen(const std::optional<Clipped>& piece) { return piece && isFinite(piece->segment); }

// Whether a point is in the set after a step, if it was before and if it is in the step's window.
bool after(WindowOperation operation, bool before, bool inWindow)
{
    if (operation == WindowOperation::Add)
        return before || inWindow;
    return before && (operation == WindowOperation::CutOut) != inWindow;
}

// Whether the points that are in no window are kept.
bool keepsUnseen(const ClipRegion& region)
{
    bool in = region.startsFull();
    for (const auto& step : region.steps)
        in = after(step.operation, in, false);
    return region.everything() || in == (region.keep == Keep::Inside);
}

// Whether a line is kept that each window contains whole or not at all; nothing if one cuts it.
std::optional<bool> keepsUncut(const ClipRegion& region, const Segment& line, Pieces atStep)
{
    bool in = region.startsFull();
    for (std::size_t i = 0; i < atStep.size(); ++i) {
        const bool seen = isSeen(atStep[i]);
        if (seen && std::memcmp(&atStep[i]->segment, &line, sizeof line) != 0)
            return std::nullopt;
        in = after(region.steps[i].operation, in, seen);
    }
    return in == (region.keep == Keep::Inside);
}

/// The order of points along a line: on the axis on which it is longer, then on the other one.
class AlongLine {
public:
    explicit AlongLine(const Segment& line) : line_(line)
    {
        const glm::dvec2 half = line.b / 2.0 - line.a / 2.0; // the whole one may overflow
        major_ = std::abs(half.x) >= std::abs(half.y) ? 0 : 1;
    }

    bool before(const glm::dvec2& p, const glm::dvec2& q) const
    {
        return p[major_] == q[major_] ? before(p, q, 1 - major_) : before(p, q, major_);
    }

private:
    bool before(const glm::dvec2& p, const glm::dvec2& q, int axis) const
    {
        if (line_.a[axis] < line_.b[axis])
            return p[axis] < q[axis];
        return line_.a[axis] > line_.b[axis] && p[axis] > q[axis];
    }

    const Segment& line_;
    int major_;
};

constexpr double mostUlps = 64; // an end is wrong by at most so many, says `clipping::Uses`

// One unit in the last place of the largest |coordinate|, or up to twice that.
double ulpOf(const Segment& line, const clipping::Window& box)
{
    double largest = 0;
    for (const glm::dvec2& p : {line.a, line.b, box.min, box.max})
        largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    return largest * std::numeric_limits<double>::epsilon();
}

/// Where the line or a piece begins or ends.
struct Breakpoint {
    glm::dvec2 at;
    Edge edge = Edge::None; ///< of the window that made it; None: an end of the line
    double level = 0;       ///< of that edge
    int place = 0;
};

/// From one breakpoint to another, as places; `from > to`: nothing.
struct Stay {
    int from = 1, to = 0;
    bool covers(int first, int last) const { return from <= first && last <= to; }
};

/// A line divided at all its breakpoints. Where one lies is a place; places are numbered along the
/// line. The set has or lacks each place, and each open part between two places, as a whole.
class DividedLine {
public:
    DividedLine(const ClipRegion& region, const Segment& line, Pieces atStep)
        : region_(region), line_(line), along_(line)
    {
        breakpoints_ << Breakpoint{line.a} << Breakpoint{line.b};
        for (std::size_t i = 0; i < atStep.size(); ++i)
            stays_ << (isSeen(atStep[i]) ? added(*atStep[i], region.steps[i].box) : Stay{});
        numberPlaces();
    }

    void appendKept(std::uint32_t source, std::vector<Clipped>& kept) const
    {
        const int count = int(places_.size());
        for (int i = 0, begin = -1; i < count; ++i) {
            const bool goesOn = i + 1 < count && isKept(i, i + 1);
            if (begin < 0 && (goesOn || isKept(i, i)))
                begin = i;
            if (begin >= 0 && !goesOn) {
                kept.push_back(piece(begin, i, source));
                begin = -1;
            }
        }
    }

private:
    // Its stay, in numbers of breakpoints as yet.
    Stay added(const Clipped& piece, const clipping::Window& box)
    {
        const auto& [a, b] = piece.segment;
        const int first = int(breakpoints_.size());
        breakpoints_ << breakpoint(a, clipping::cutEdgeOfA(piece.cut), box);
        breakpoints_ << breakpoint(b, clipping::cutEdgeOfB(piece.cut), box);
        return along_.before(b, a) ? Stay{first + 1, first} : Stay{first, first + 1};
    }

    Breakpoint breakpoint(const glm::dvec2& at, Edge edge, const clipping::Window& box) const
    {
        if (edge == Edge::None || clipping::axisOf(edge) > 1) // a published form may give anything
            return {at};
        const double level = clipping::levelOf(edge, box);
        const int across = int(clipping::axisOf(edge)), along = 1 - across;
        const double rounding = 2 * mostUlps * ulpOf(line_, box);
        for (const Breakpoint& earlier : breakpoints_)
            if (earlier.edge != Edge::None && earlier.level == level
                && clipping::axisOf(earlier.edge) == across
                && std::abs(earlier.at[along] - at[along]) <= rounding)
                return {earlier.at, edge, level};
        return {at, edge, level};
    }

    void numberPlaces()
    {
        const auto before = [this](int i, int j) {
            return along_.before(breakpoints_[i].at, breakpoints_[j].at);
        };
        QVarLengthArray<int, 32> order(breakpoints_.size());
        std::iota(order.begin(), order.end(), 0);
        std::ranges::sort(order, [&](int i, int j) {
            return before(i, j) || (i < j && !before(j, i)); // the first of a place stands for it
        });
        for (const int i : order) {
            if (places_.isEmpty() || before(places_.last(), i))
                places_ << i;
            breakpoints_[i].place = int(places_.size()) - 1;
        }
        whole_ = {breakpoints_[0].place, breakpoints_[1].place};
        for (Stay& stay : stays_)
            if (stay.from > 1) { // 0 and 1 are the line's ends
                const int from = breakpoints_[stay.from].place;
                stay = {from, std::max(from, breakpoints_[stay.to].place)};
            }
    }

    // A place if both are the same, else the open part between two that follow each other.
    bool isKept(int first, int last) const
    {
        const bool onLine = whole_.covers(first, last);
        bool in = region_.startsFull() && onLine;
        for (std::size_t i = 0; i < region_.steps.size(); ++i)
            in = after(region_.steps[i].operation, in, stays_[int(i)].covers(first, last));
        return region_.keep == Keep::Inside ? in : onLine && !in;
    }

    Clipped piece(int first, int last, std::uint32_t source) const
    {
        const bool startsAtA = first == whole_.from, endsAtB = last == whole_.to;
        const glm::dvec2& a = breakpoints_[places_[first]].at;
        const glm::dvec2& b = breakpoints_[places_[last]].at;
        const Edge edgeOfA =
            startsAtA ? Edge::None : edgeAt(first, breakpoints_.begin(), breakpoints_.end());
        const Edge edgeOfB =
            endsAtB ? Edge::None : edgeAt(last, breakpoints_.rbegin(), breakpoints_.rend());
        // A point's two ends may be 0 and -0.
        return {{a, endsAtB ? line_.b : b}, source, clipping::cutAt(edgeOfA, edgeOfB)};
    }

    // That of the first breakpoint there which has one. A contact may be on two edges: the first
    // is that of its a, the last that of its b.
    static Edge edgeAt(int place, auto first, auto end)
    {
        const auto found = std::find_if(first, end, [&](const Breakpoint& each) {
            return each.place == place && each.edge != Edge::None;
        });
        return found == end ? Edge::None : found->edge;
    }

    const ClipRegion& region_;
    const Segment& line_;
    const AlongLine along_;
    QVarLengthArray<Breakpoint, 32> breakpoints_;
    QVarLengthArray<Stay, 16> stays_; ///< what each step's window contains
    QVarLengthArray<int, 32> places_; ///< the first breakpoint at each
    Stay whole_;
};

void foldSingle(Keep keep, const Segment& line, std::uint32_t source, std::optional<Clipped> piece,
                std::vector<Clipped>& kept)
{
    if (keep == Keep::Outside) {
        std::array<Clipped, 2> outside{};
        if (piece)
            piece->source = 0;
        const std::span inside(piece ? &*piece : nullptr, piece ? 1 : 0);
        const std::size_t count = clipping::outsideAll(std::span(&line, 1), inside, outside);
        for (Clipped& each : std::span(outside).first(count))
            kept.push_back({each.segment, source, each.cut});
    } else if (piece) {
        kept.push_back({piece->segment, source, piece->cut});
    }
}

} // namespace

void fold(const ClipRegion& region, const Segment& line, std::uint32_t source, Pieces atStep,
          std::vector<Clipped>& kept)
{
    assert(atStep.size() == region.steps.size());
    if (region.single()) {
        foldSingle(region.keep, line, source, isSeen(atStep[0]) ? atStep[0] : std::nullopt, kept);
        return;
    }
    std::optional<bool> keeps = keepsUnseen(region);
    if (isFinite(line) && std::ranges::any_of(atStep, isSeen))
        keeps = keepsUncut(region, line, atStep);
    if (!keeps)
        DividedLine(region, line, atStep).appendKept(source, kept);
    else if (*keeps)
        kept.push_back({line, source, 0});
}

} // namespace app
