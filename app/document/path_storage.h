// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/path.h"

#include <atomic>
#include <cassert>
#include <new>

// How the points of a path are packed; for the functions of `Path` only.

namespace app {

/// The head of a heap block. Behind it: the points (of a curve its controls, then its end), how
/// many segments each subpath has (and in the lowest bit whether it is closed), and, if any segment
/// is a curve, a byte for each of them: 1 for a curve.
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

/// Unpacks one subpath after the other, whole or segment by segment.
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

    /// How a subpath begins, and how many segments are to be asked for before the next one.
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
