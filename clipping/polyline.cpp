// SPDX-License-Identifier: MIT
#include "clipping/polyline.h"

#include "clipping/batch/kernels.h"
#include "clipping/ieee_numbers.h"

#include <algorithm>
#include <array>

namespace clipping {
namespace {

/// Joins visible pieces, in the order of the polyline, into runs.
class Joiner {
public:
    explicit Joiner(PolylineRuns& out) : out_(out)
    {
        out_.points.clear();
        out_.runs.clear();
    }

    /// Adds the visible piece of a segment. `follows`: the previous piece belongs to the previous
    /// segment.
    void add(const Segment& whole, const Clipped& piece, bool follows)
    {
        const auto& [a, b] = piece.segment;
        const Edge enter = cutEdgeOfA(piece.cut), leave = cutEdgeOfB(piece.cut);
        if (!follows || enter != Edge::None)
            begin(piece.source, a, enter);
        VisibleRun& run = out_.runs.back();
        run.end = leave;
        if (a != b || whole.a == whole.b)
            out_.points.push_back(b);
        else if (leave == Edge::None)
            out_.points.back() = b; // use the polyline's own point, because its zero may be -0
        run.count = out_.points.size() - run.first;
    }

private:
    void begin(std::uint32_t source, const glm::dvec2& a, Edge edge)
    {
        out_.runs.push_back({out_.points.size(), 0, source, edge, Edge::None});
        out_.points.push_back(a);
    }
    PolylineRuns& out_;
};

/// Clips `count` segments, beginning with the one at point `start`; the last point is followed by
/// the first.
void clipFrom(std::size_t start, std::size_t count, std::span<const glm::dvec2> points,
              const Window& window, PolylineRuns& out)
{
    constexpr std::size_t block = 256;
    std::array<Segment, block> segments;
    std::array<Clipped, block> pieces;
    Joiner joiner(out);
    // The next point, and the segment that would continue the run.
    std::size_t at = start, next = start;
    while (count > 0) {
        const std::size_t size = std::min({count, block, points.size() - at});
        for (std::size_t i = 0; i < size; ++i)
            segments[i] = {points[at + i], points[(at + i + 1) % points.size()]};
        const auto found =
            clipBatch(Batch<double>{segments.data(), 0, size, window, pieces.data()});
        for (Clipped& piece : std::span(pieces).first(found.pieces)) {
            const Segment& whole = segments[piece.source];
            piece.source += static_cast<std::uint32_t>(at);
            joiner.add(whole, piece, piece.source == next && !out.runs.empty());
            next = (piece.source + 1) % points.size();
        }
        at = (at + size) % points.size();
        count -= size;
    }
}

bool contains(const Window& w, const glm::dvec2& p)
{
    return p.x >= w.min.x && p.x <= w.max.x && p.y >= w.min.y && p.y <= w.max.y;
}

} // namespace

void clipPolyline(std::span<const glm::dvec2> points, const Window& window, PolylineRuns& out)
{
    // A single point is clipped as a segment to itself, whose second end is then dropped.
    clipFrom(0, points.size() == 1 ? 1 : points.size() - !points.empty(), points, window, out);
    if (points.size() == 1 && !out.runs.empty()) {
        out.points.pop_back();
        out.runs.front().count = 1;
    }
}

void clipClosedPolyline(std::span<const glm::dvec2> points, const Window& window, PolylineRuns& out)
{
    // No run passes through a point outside, so starting there splits no run.
    const auto outside =
        std::ranges::find_if(points, [&](const glm::dvec2& p) { return !contains(window, p); });
    const auto start = static_cast<std::size_t>(outside - points.begin());
    clipFrom(start == points.size() ? 0 : start, points.size(), points, window, out);
}

} // namespace clipping
