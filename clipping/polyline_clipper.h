// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/batch/kernels.h"
#include "clipping/polyline.h"

#include <algorithm>
#include <array>
#include <utility>

namespace clipping {

/// Clips many polylines at a window, as clipPolyline or clipClosedPolyline (polyline.h) clips each.
/// Their points lie in `points`, of which there are fewer than 2^32; the source of a run is the
/// index there of the point where its first segment begins.
///
/// The runs are given to `sink`, in order and only when they are complete: `sink.addPoints(span)`
/// gets their points one after the other, `sink.addRuns(span)` the runs, after all their points.
/// VisibleRun::first counts the points that the sink got. Call finish() at the end.
template <class T, class Sink>
class PolylineClipper {
public:
    using Point = glm::vec<2, T>;

    PolylineClipper(std::span<const Point> points, bool closed, const BasicWindow<T>& window,
                    Sink& sink)
        : points_(points), closed_(closed), window_(window), sink_(sink)
    {
        newRuns_[0] = {};
    }

    /// Adds the polyline with the points from `begin` up to, not including, `end`.
    void add(std::size_t begin, std::size_t end)
    {
        // Reads as many points as it takes to know that it crosses an edge.
        unsigned all = ~0u;
        std::size_t outside = end; // the first point outside
        for (std::size_t at = begin; at < end && (all != 0 || outside == end); ++at) {
            const unsigned sides = sidesOf(points_[at]);
            all &= sides;
            if (sides != 0 && outside == end)
                outside = at;
        }
        if (all != 0) // beyond one edge, or without a point
            return;
        if (outside == end)
            return addWhole(begin, end);
        // No run passes through a point outside, so starting there splits no run.
        const std::size_t start = closed_ ? outside : begin;
        addSegments(start, end - 1);
        if (closed_)
            addSegment(end - 1, begin);
        addSegments(begin, start);
    }

    /// Gives what is left.
    void finish()
    {
        clip();
        if (hasRun_)
            give(newRuns_.data() + 1, newPoints_.data() + 1);
        hasRun_ = false;
    }

private:
    static constexpr std::size_t block = 256;
    static constexpr std::uint32_t noPoint = 0xffffffff; // there are fewer

    /// The edges beyond which a point is; NaN is beyond two of them.
    unsigned sidesOf(const Point& p) const
    {
        return unsigned(!(p.x >= window_.min.x)) | unsigned(!(p.x <= window_.max.x)) << 1
               | unsigned(!(p.y >= window_.min.y)) << 2 | unsigned(!(p.y <= window_.max.y)) << 3;
    }

    void addWhole(std::size_t begin, std::size_t end)
    {
        finish();
        const VisibleRun run{given_, end - begin + closed_, static_cast<std::uint32_t>(begin),
                             Edge::NoEdge, Edge::NoEdge};
        sink_.addPoints(points_.subspan(begin, end - begin));
        if (closed_)
            sink_.addPoints(points_.subspan(begin, 1));
        sink_.addRuns(std::span(&run, 1));
        given_ += run.count;
    }

    void addSegment(std::size_t from, std::size_t to)
    {
        segments_[size_] = {points_[from], points_[to]};
        from_[size_] = static_cast<std::uint32_t>(from);
        to_[size_] = static_cast<std::uint32_t>(to);
        if (++size_ == block)
            clip();
    }

    /// Adds the segments from each point to the next.
    void addSegments(std::size_t first, std::size_t last)
    {
        while (first < last) {
            const std::size_t count = std::min(last - first, block - size_);
            for (std::size_t i = 0; i < count; ++i) {
                segments_[size_ + i] = {points_[first + i], points_[first + i + 1]};
                from_[size_ + i] = static_cast<std::uint32_t>(first + i);
                to_[size_ + i] = static_cast<std::uint32_t>(first + i + 1);
            }
            first += count;
            size_ += count;
            if (size_ == block)
                clip();
        }
    }

    /// Clips the block of segments, and joins their visible pieces to runs.
    void clip()
    {
        const auto found = clipBatch(Batch<T>{segments_.data(), 0, size_, window_, pieces_.data()});
        size_ = 0;
        if (found.pieces == 0)
            return;
        VisibleRun* run = newRuns_.data();
        Point* end = newPoints_.data() + 1;
        const std::size_t before = given_ + hasRun_;
        const auto size = [&] { return before + std::size_t(end - newPoints_.data()) - 1; };
        for (const auto& piece : std::span(pieces_).first(found.pieces)) {
            const std::uint32_t i = piece.source, from = from_[i];
            const bool follows = from == std::exchange(next_, to_[i]);
            const auto [a, b] = piece.segment;
            if (piece.cut == 0 && follows) { // most pieces of long polylines
                *end++ = b;
                continue;
            }
            // Whether a run begins is hard to predict, so it decides no branch.
            const Edge enter = cutEdgeOfA(piece.cut), leave = cutEdgeOfB(piece.cut);
            const bool begins = !follows || enter != Edge::NoEdge;
            run->count = size() - run->first;
            run[1] = {size(), 0, from, enter, leave};
            run += begins;
            run->end = leave;
            *end = a;
            end += begins;
            *end = b;
            const auto& whole = segments_[i];
            if (a != b || whole.a == whole.b) [[likely]]
                ++end;
            else if (leave == Edge::NoEdge)
                end[-1] = b; // use the polyline's own point, because its zero may be -0
        }
        run->count = size() - run->first;
        give(run, end - 1); // not the last run: it may continue
        newRuns_[0] = *run;
        newPoints_[0] = end[-1];
        hasRun_ = true;
    }

    void give(const VisibleRun* runsEnd, const Point* pointsEnd)
    {
        const Point* const points = newPoints_.data() + !hasRun_;
        given_ += std::size_t(pointsEnd - points);
        sink_.addPoints(std::span(points, pointsEnd));
        sink_.addRuns(std::span<const VisibleRun>(newRuns_.data() + !hasRun_, runsEnd));
    }

    std::span<const Point> points_;
    bool closed_;
    BasicWindow<T> window_;
    Sink& sink_;
    std::size_t given_ = 0;        // points
    std::uint32_t next_ = noPoint; // from which a segment would continue the last run
    std::size_t size_ = 0;         // of the block
    std::array<BasicSegment<T>, block> segments_;
    std::array<std::uint32_t, block> from_, to_; // their points
    std::array<BasicClipped<BasicSegment<T>>, block> pieces_;
    // The first ones are the last run so far, with its last point; if there is one.
    std::array<VisibleRun, block + 2> newRuns_;
    std::array<Point, 2 * block + 2> newPoints_;
    bool hasRun_ = false;
};

} // namespace clipping
