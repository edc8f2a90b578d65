// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/divided_line.h"

#include <QVarLengthArray>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace app {
namespace {

using clipping::Clipped;
using clipping::Edge;
using clipping::Segment;

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

/// A line divided at the ends of all pieces. Where one lies is a place; places are numbered along
/// the line. The set has or lacks each place, and each open part between two places, as a whole.
class DividedLine {
public:
    DividedLine(const ClipRegion& region, const Segment& line, PiecesOfLine atStep)
        : region_(region), line_(line), along_(line)
    {
        breakpoints_ << Breakpoint{line.a} << Breakpoint{line.b};
        for (std::size_t i = 0; i < atStep.size(); ++i)
            steps_ << Step{isSeen(atStep[i]) ? added(*atStep[i], region.steps[i].box) : Stay{}};
        joinOnEdges();
        numberPlaces();
        enterSteps();
    }

    void appendKept(std::uint32_t source, std::vector<Clipped>& kept)
    {
        const int count = int(places_.size());
        for (int i = 0, begin = -1; i < count; ++i) {
            for (int step = places_[i].starting; step >= 0; step = steps_[step].nextStarting)
                flip(step);
            if (begin < 0 && isKept(whole_.covers(i, i)))
                begin = i;
            for (int step = places_[i].ending; step >= 0; step = steps_[step].nextEnding)
                flip(step);
            const bool goesOn = i + 1 < count && isKept(whole_.covers(i, i + 1));
            if (begin < 0 && goesOn)
                begin = i;
            if (begin >= 0 && !goesOn) {
                kept.push_back(piece(begin, i, source));
                begin = -1;
            }
        }
    }

private:
    /// Where the line or a piece begins or ends.
    struct Breakpoint {
        glm::dvec2 at;
        Edge edge = Edge::None; ///< of the window; None: an end of the line
        double level = 0;       ///< of that edge
        double rounding = 0;    ///< how far an algorithm may be out along it
        int place = 0;
    };
    /// From one breakpoint to another, as places; `from > to`: nothing.
    struct Stay {
        int from = 1, to = 0;
        bool covers(int first, int last) const { return from <= first && last <= to; }
    };
    struct Place {
        int breakpoint; ///< the first of those there
        /// Of the first and the last breakpoint there that has one.
        Edge firstEdge = Edge::None, lastEdge = Edge::None;
        int starting = -1, ending = -1; ///< the first step whose stay does; the next is in its Step
    };
    /// What a step's window contains.
    struct Step {
        Stay stay;
        int nextStarting = -1, nextEnding = -1;
    };

    // Its stay, in numbers of breakpoints as yet.
    Stay added(const Clipped& piece, const clipping::Window& box)
    {
        const auto& [a, b] = piece.segment;
        const int first = int(breakpoints_.size());
        add(a, clipping::cutEdgeOfA(piece.cut), box);
        add(b, clipping::cutEdgeOfB(piece.cut), box);
        return along_.before(b, a) ? Stay{first + 1, first} : Stay{first, first + 1};
    }

    void add(const glm::dvec2& at, Edge edge, const clipping::Window& box)
    {
        if (edge == Edge::None || clipping::axisOf(edge) > 1) // a published form may give anything
            breakpoints_ << Breakpoint{at};
        else
            breakpoints_ << Breakpoint{at, edge, clipping::levelOf(edge, box),
                                       2 * mostUlps * ulpOf(line_, box)};
    }

    // Ends on the same level that differ by rounding alone are one place: that of the first.
    void joinOnEdges()
    {
        const auto axis = [](const Breakpoint& b) { return int(clipping::axisOf(b.edge)); };
        const auto sameLevel = [&](const Breakpoint& a, const Breakpoint& b) {
            return a.level == b.level && axis(a) == axis(b);
        };
        QVarLengthArray<int, 32> order;
        for (int i = 0; i < breakpoints_.size(); ++i)
            if (breakpoints_[i].edge != Edge::None && !std::isnan(breakpoints_[i].level))
                order << i;
        const bool sorted = order.size() > 16; // fewer are searched as quickly
        if (sorted)
            std::ranges::sort(order, [&](int i, int j) {
                const Breakpoint &a = breakpoints_[i], &b = breakpoints_[j];
                if (sameLevel(a, b))
                    return i < j;
                return axis(a) == axis(b) ? a.level < b.level : axis(a) < axis(b);
            });
        for (auto first = order.begin(), each = first; each != order.end(); ++each) {
            Breakpoint& here = breakpoints_[*each];
            if (sorted && !sameLevel(breakpoints_[*first], here))
                first = each;
            const int along = 1 - axis(here);
            const auto same = std::find_if(first, each, [&](int i) {
                const Breakpoint& other = breakpoints_[i];
                return sameLevel(other, here)
                       && std::abs(other.at[along] - here.at[along]) <= here.rounding;
            });
            if (same != each)
                here.at = breakpoints_[*same].at;
        }
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
            if (places_.isEmpty() || before(places_.last().breakpoint, i))
                places_ << Place{i};
            breakpoints_[i].place = int(places_.size()) - 1;
            if (const Edge edge = breakpoints_[i].edge; edge != Edge::None) {
                Place& place = places_.last();
                place.firstEdge = place.firstEdge == Edge::None ? edge : place.firstEdge;
                place.lastEdge = edge;
            }
        }
        whole_ = {breakpoints_[0].place, breakpoints_[1].place};
    }

    void enterSteps()
    {
        deciding_.resize((steps_.size() + 63) / 64, 0);
        for (int i = 0; i < steps_.size(); ++i) {
            if (region_.steps[std::size_t(i)].operation == WindowOperation::Intersect)
                flip(i); // where its window has nothing
            auto& [stay, nextStarting, nextEnding] = steps_[i];
            if (stay.from <= 1) // 0 and 1 are the line's ends
                continue;
            const int from = breakpoints_[stay.from].place;
            stay = {from, std::max(from, breakpoints_[stay.to].place)};
            nextStarting = std::exchange(places_[stay.from].starting, i);
            nextEnding = std::exchange(places_[stay.to].ending, i);
        }
    }

    void flip(int step) { deciding_[step / 64] ^= std::uint64_t(1) << step % 64; }

    // What is at present, on the line itself or beyond its ends.
    bool isKept(bool onLine) const
    {
        bool in = region_.startsFull() && onLine;
        for (auto i = deciding_.size(); i-- > 0;)
            if (deciding_[i] != 0) {
                const auto last = 64 * std::size_t(i) + std::bit_width(deciding_[i]) - 1;
                in = region_.steps[last].operation == WindowOperation::Add;
                break;
            }
        return region_.keep == Keep::Inside ? in : onLine && !in;
    }

    Clipped piece(int first, int last, std::uint32_t source) const
    {
        const bool startsAtA = first == whole_.from, endsAtB = last == whole_.to;
        const glm::dvec2& a = breakpoints_[places_[first].breakpoint].at;
        const glm::dvec2& b = breakpoints_[places_[last].breakpoint].at;
        // A contact may be on two edges: the first is that of its a, the last that of its b.
        const Edge edgeOfA = startsAtA ? Edge::None : places_[first].firstEdge;
        const Edge edgeOfB = endsAtB ? Edge::None : places_[last].lastEdge;
        // A point's two ends may be 0 and -0.
        return {{a, endsAtB ? line_.b : b}, source, clipping::cutAt(edgeOfA, edgeOfB)};
    }

    const ClipRegion& region_;
    const Segment& line_;
    const AlongLine along_;
    QVarLengthArray<Breakpoint, 32> breakpoints_;
    QVarLengthArray<Step, 16> steps_;
    QVarLengthArray<Place, 32> places_;
    Stay whole_;
    /// A bit for each step, set where it decides alone, whatever the steps before it leave: the
    /// last of these is right.
    QVarLengthArray<std::uint64_t, 16> deciding_;
};

} // namespace

void foldDivided(const ClipRegion& region, const Segment& line, std::uint32_t source,
                 PiecesOfLine atStep, std::vector<Clipped>& kept)
{
    DividedLine(region, line, atStep).appendKept(source, kept);
}

} // namespace app
