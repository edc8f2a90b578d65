// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/divided_line.h"

#include <QVarLengthArray>

#include <glm/common.hpp>

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

/// Orders points along a line: by the axis on which the line is longer, then by the other axis.
class AlongLine {
public:
    explicit AlongLine(const Segment& line) : line_(line)
    {
        const glm::dvec2 half = line.b / 2.0 - line.a / 2.0; // the full difference may overflow
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

// The largest errors of an end, in ulps of the largest coordinate: at a window along the axes, as
// `clipping::Functions` states, and at any other window (`turnedUlps`).
constexpr double mostUlps = 64, mostShapedUlps = 6 * mostUlps + 20;

// One to two units in the last place of the largest |coordinate|.
double ulpOf(const Segment& line, const clipping::Window& box)
{
    double largest = 0;
    for (const glm::dvec2& p : {line.a, line.b, box.min, box.max})
        largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    return largest * std::numeric_limits<double>::epsilon();
}

/// A line divided at the ends of all pieces. Each division point is a place; places are numbered
/// along the line. Each place, and each open part between adjacent places, lies entirely in the set
/// or entirely outside it.
class DividedLine {
public:
    DividedLine(const ClipRegion& region, const Segment& line, PiecesOfLine atStep)
        : region_(region), line_(line), along_(line)
    {
        breakpoints_ << Breakpoint{line.a} << Breakpoint{line.b};
        for (std::size_t i = 0; i < atStep.size(); ++i)
            steps_ << Step{isSeen(atStep[i]) ? added(*atStep[i], region.steps[i].box) : Stay{}};
        joinOnEdges();
        joinAtBorders();
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
    /// An end of the line or of a piece.
    struct Breakpoint {
        glm::dvec2 at;
        Edge edge = Edge::NoEdge; ///< of the window; NoEdge: an end of the line
        double level = 0;         ///< of that edge; NaN: a border that is not along an axis
        double rounding = 0;      ///< the largest rounding error of an algorithm along the edge
        int place = 0;
    };
    /// A range of places inside a window, both ends included; `from > to`: empty.
    struct Stay {
        int from = 1, to = 0;
        bool covers(int first, int last) const { return from <= first && last <= to; }
    };
    struct Place {
        int breakpoint; ///< the first breakpoint at this place
        /// The edges of the first and of the last breakpoint at this place that have an edge.
        Edge firstEdge = Edge::NoEdge, lastEdge = Edge::NoEdge;
        int starting = -1, ending = -1; ///< the first step whose stay starts or ends here; Step
                                        ///< links to the next
    };
    /// The part of the line inside a step's window.
    struct Step {
        Stay stay;
        int nextStarting = -1, nextEnding = -1;
    };

    // The piece's stay, still in breakpoint numbers.
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
        if (edge == borderEdge)
            breakpoints_ << Breakpoint{at, edge, std::numeric_limits<double>::quiet_NaN(),
                                       2 * mostShapedUlps * ulpOf(line_, box)};
        else if (edge == Edge::NoEdge || clipping::axisOf(edge) > 1) // published forms say anything
            breakpoints_ << Breakpoint{at};
        else
            breakpoints_ << Breakpoint{at, edge, clipping::levelOf(edge, box),
                                       2 * mostUlps * ulpOf(line_, box)};
    }

    // Merges ends on the same level that differ only by rounding into one place, at the first of
    // them.
    void joinOnEdges()
    {
        const auto axis = [](const Breakpoint& b) { return int(clipping::axisOf(b.edge)); };
        const auto sameLevel = [&](const Breakpoint& a, const Breakpoint& b) {
            return a.level == b.level && axis(a) == axis(b);
        };
        QVarLengthArray<int, 32> order;
        for (int i = 0; i < breakpoints_.size(); ++i)
            if (breakpoints_[i].edge != Edge::NoEdge && !std::isnan(breakpoints_[i].level))
                order << i;
        const bool sorted = order.size() > 16; // a linear search is as fast for fewer
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

    // Merges an end at a border that is not along an axis with an earlier end that differs from it
    // only by rounding: no level tells whether they are at the same edge.
    void joinAtBorders()
    {
        for (int i = 2; i < breakpoints_.size(); ++i) {
            Breakpoint& here = breakpoints_[i];
            if (here.edge == Edge::NoEdge)
                continue;
            const auto same = std::find_if(
                breakpoints_.begin() + 2, breakpoints_.begin() + i, [&](const Breakpoint& other) {
                    if (other.edge != borderEdge && here.edge != borderEdge)
                        return false;
                    const auto apart = glm::abs(other.at - here.at);
                    const double most = std::max(other.rounding, here.rounding);
                    return other.edge != Edge::NoEdge && apart.x <= most && apart.y <= most;
                });
            if (same != breakpoints_.begin() + i)
                here.at = same->at;
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
            return before(i, j) || (i < j && !before(j, i)); // the first represents its place
        });
        for (const int i : order) {
            if (places_.isEmpty() || before(places_.last().breakpoint, i))
                places_ << Place{i};
            breakpoints_[i].place = int(places_.size()) - 1;
            if (const Edge edge = breakpoints_[i].edge; edge != Edge::NoEdge) {
                Place& place = places_.last();
                place.firstEdge = place.firstEdge == Edge::NoEdge ? edge : place.firstEdge;
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
                flip(i); // it decides where its window has no points
            auto& [stay, nextStarting, nextEnding] = steps_[i];
            if (stay.from <= 1) // breakpoints 0 and 1 are the line's ends
                continue;
            const int from = breakpoints_[stay.from].place;
            stay = {from, std::max(from, breakpoints_[stay.to].place)};
            nextStarting = std::exchange(places_[stay.from].starting, i);
            nextEnding = std::exchange(places_[stay.to].ending, i);
        }
    }

    void flip(int step) { deciding_[step / 64] ^= std::uint64_t(1) << step % 64; }

    // Whether the current position is kept, on the line itself or beyond its ends.
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
        // A contact may lie on two edges: the first is its edge of a, the last its edge of b.
        const Edge edgeOfA = startsAtA ? Edge::NoEdge : places_[first].firstEdge;
        const Edge edgeOfB = endsAtB ? Edge::NoEdge : places_[last].lastEdge;
        // The two ends of a point may be 0 and -0.
        return {{a, endsAtB ? line_.b : b}, source, clipping::cutAt(edgeOfA, edgeOfB)};
    }

    const ClipRegion& region_;
    const Segment& line_;
    const AlongLine along_;
    QVarLengthArray<Breakpoint, 32> breakpoints_;
    QVarLengthArray<Step, 16> steps_;
    QVarLengthArray<Place, 32> places_;
    Stay whole_;
    /// One bit for each step, set while the step alone decides, regardless of the steps before it.
    /// The last set bit gives the result.
    QVarLengthArray<std::uint64_t, 16> deciding_;
};

} // namespace

void foldDivided(const ClipRegion& region, const Segment& line, std::uint32_t source,
                 PiecesOfLine atStep, std::vector<Clipped>& kept)
{
    DividedLine(region, line, atStep).appendKept(source, kept);
}

} // namespace app
