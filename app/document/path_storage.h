// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/path.h"

#include <atomic>
#include <cassert>
#include <new>

// The storage of the points of a path; only for the member functions of `Path`.

namespace app {

/// The header of the heap block. It is followed by the points (for a curve: its control points,
/// then its end), by one number for each subpath (the segment count, with the lowest bit set if the
/// subpath is closed), and, if any segment is a curve, by one byte for each segment: 1 for a curve.
struct Path::Data {
    std::atomic<std::uint32_t> owners{1};
    std::uint32_t pointCount = 0;
    std::uint32_t subpathCount = 0;
    std::uint32_t kindCount = 0; // 0: only lines

    static Data* of(std::size_t points, std::size_t subpaths, std::size_t kinds);
    std::size_t bytes() const { return bytes(pointCount, subpathCount, kindCount); }
    std::span<const Point> points() const { return {firstPoint(), pointCount}; }
    std::span<const std::uint32_t> sizes() const { return {firstSize(), subpathCount}; }
    std::span<const std::uint8_t> kinds() const { return {firstKind(), kindCount}; }

    Point* firstPoint() const { return reinterpret_cast<Point*>(const_cast<Data*>(this) + 1); }
    std::uint32_t* firstSize() const
    {
        return reinterpret_cast<std::uint32_t*>(firstPoint() + pointCount);
    }
    std::uint8_t* firstKind() const
    {
        return reinterpret_cast<std::uint8_t*>(firstSize() + subpathCount);
    }

    class Reader;

private:
    static std::size_t bytes(std::size_t points, std::size_t subpaths, std::size_t kinds)
    {
        return sizeof(Data) + points * sizeof(Point) + subpaths * sizeof(std::uint32_t) + kinds;
    }
};

inline Path::Data* Path::Data::of(std::size_t points, std::size_t subpaths, std::size_t kinds)
{
    assert(points < (std::size_t(1) << 31) && subpaths <= points);
    return new (::operator new(bytes(points, subpaths, kinds)))
        Data{{1}, std::uint32_t(points), std::uint32_t(subpaths), std::uint32_t(kinds)};
}

/// Unpacks the subpaths in order, each as a whole or segment by segment.
class Path::Data::Reader {
public:
    Reader(const Data& data, const Placement& where)
        : where_(where), size_(data.firstSize()), end_(size_ + data.subpathCount),
          point_(data.firstPoint()), kind_(data.kindCount ? data.firstKind() : nullptr)
    {
    }

    bool atEnd() const { return size_ == end_; }

    void next(Subpath& subpath)
    {
        const auto [start, segments, closed] = this->start();
        subpath.closed = closed;
        subpath.start = start;
        subpath.segments.clear();
        subpath.segments.reserve(segments);
        for (std::uint32_t left = segments; left > 0; --left)
            subpath.segments.push_back(segment());
    }

    /// The start of a subpath, and the number of segments to read before the next subpath.
    struct Start {
        Point at;
        std::uint32_t segments;
        bool closed;
    };
    Start start()
    {
        const std::uint32_t size = *size_++;
        return {point(), size >> 1, (size & 1) != 0};
    }
    PathSegment segment()
    {
        PathSegment segment{};
        segment.curved = kind_ && *kind_++;
        if (segment.curved) {
            segment.control1 = point();
            segment.control2 = point();
        }
        segment.to = point();
        return segment;
    }

private:
    Point point() { return where_(*point_++); }

    const Placement where_;
    const std::uint32_t* size_;
    const std::uint32_t* const end_;
    const Point* point_;
    const std::uint8_t* kind_;
};

} // namespace app
