// SPDX-License-Identifier: MIT
#include "clipping/polyline_runs.h"

#include "clipping/batch/kernels.h"
#include "clipping/ieee_numbers.h"

#include <algorithm>
#include <array>

namespace clipping {
namespace {

/// Joins visible pieces, in the order of the polyline, into runs.
template <class T>
class Joiner {
public:
    explicit Joiner(BasicPolylineRuns<T>& out) : out_(out)
    {
        out_.points.clear();
        out_.runs.clear();
    }

    /// Adds the visible piece of a segment. `follows`: the previous piece belongs to the previous
    /// segment.
    void add(const BasicSegment<T>& whole, const BasicClipped<BasicSegment<T>>& piece, bool follows)
    {
        const auto& [a, b] = piece.segment;
        const Edge enter = cutEdgeOfA(piece.cut), leave = cutEdgeOfB(piece.cut);
        if (!follows || enter != Edge::NoEdge)
            begin(piece.source, a, enter);
        VisibleRun& run = out_.runs.back();
        run.end = leave;
        if (a != b || whole.a == whole.b)
            out_.points.push_back(b);
        else if (leave == Edge::NoEdge)
            out_.points.back() = b; // use the polyline's own point, because its zero may be -0
        run.count = out_.points.size() - run.first;
    }

private:
    void begin(std::uint32_t source, const glm::vec<2, T>& a, Edge edge)
    {
        out_.runs.push_back({out_.points.size(), 0, source, edge, Edge::NoEdge});
        out_.points.push_back(a);
    }
    BasicPolylineRuns<T>& out_;
};

/// Clips `count` segments, beginning with the one at point `start`; the last point is followed by
/// the first.
template <class T>
void clipFrom(std::size_t start, std::size_t count, std::span<const glm::vec<2, T>> points,
              const BasicWindow<T>& window, BasicPolylineRuns<T>& out)
{
    constexpr std::size_t block = 256;
    std::array<BasicSegment<T>, block> segments;
    std::array<BasicClipped<BasicSegment<T>>, block> pieces;
    Joiner joiner(out);
    // The next point, and the segment that would continue the run.
    std::size_t at = start, next = start;
    while (count > 0) {
        const std::size_t size = std::min({count, block, points.size() - at});
        for (std::size_t i = 0; i < size; ++i)
            segments[i] = {points[at + i], points[(at + i + 1) % points.size()]};
        const auto found = clipBatch(Batch<T>{segments.data(), 0, size, window, pieces.data()});
        for (auto& piece : std::span(pieces).first(found.pieces)) {
            const BasicSegment<T>& whole = segments[piece.source];
            piece.source += static_cast<std::uint32_t>(at);
            joiner.add(whole, piece, piece.source == next && !out.runs.empty());
            next = (piece.source + 1) % points.size();
        }
        at = (at + size) % points.size();
        count -= size;
    }
}

template <class T>
bool contains(const BasicWindow<T>& w, const glm::vec<2, T>& p)
{
    return p.x >= w.min.x && p.x <= w.max.x && p.y >= w.min.y && p.y <= w.max.y;
}

template <class T>
void clipOpen(std::span<const glm::vec<2, T>> points, const BasicWindow<T>& window,
              BasicPolylineRuns<T>& out)
{
    // A single point is clipped as a segment to itself, whose second end is then dropped.
    clipFrom(0, points.size() == 1 ? 1 : points.size() - !points.empty(), points, window, out);
    if (points.size() == 1 && !out.runs.empty()) {
        out.points.pop_back();
        out.runs.front().count = 1;
    }
}

template <class T>
void clipClosed(std::span<const glm::vec<2, T>> points, const BasicWindow<T>& window,
                BasicPolylineRuns<T>& out)
{
    // No run passes through a point outside, so starting there splits no run.
    const auto outside =
        std::ranges::find_if(points, [&](const auto& p) { return !contains(window, p); });
    const auto start = static_cast<std::size_t>(outside - points.begin());
    clipFrom(start == points.size() ? 0 : start, points.size(), points, window, out);
}

} // namespace

template <class T>
void findRuns(std::span<const glm::vec<2, T>> points, bool closed, const BasicWindow<T>& window,
              BasicPolylineRuns<T>& out)
{
    (closed ? clipClosed<T> : clipOpen<T>)(points, window, out);
}
template void findRuns(std::span<const glm::dvec2>, bool, const Window&, PolylineRuns&);
template void findRuns(std::span<const glm::vec2>, bool, const BasicWindow<float>&,
                       BasicPolylineRuns<float>&);

void clipPolyline(std::span<const glm::dvec2> points, const Window& window, PolylineRuns& out)
{
    clipOpen(points, window, out);
}

void clipClosedPolyline(std::span<const glm::dvec2> points, const Window& window, PolylineRuns& out)
{
    clipClosed(points, window, out);
}

} // namespace clipping
