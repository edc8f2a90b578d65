// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "tests/benchmarks/peers/lines.h"

// OpenCV's clipLine knows whole numbers only, so it gets rounded segments, and its results are
// compared with ours on the same rounded ones. Outcodes, then the y edges, then the x edges, from
// where the y edges left a rounded end: on steep and on long lines that takes it far from the line.

namespace {

constexpr double anywhere = 200; // the width of the window: only what is visible is tested

template <class Point>
struct IntegerLine {
    Point a, b;
};
template <class Point>
IntegerLine<Point> rounded(const clipping::Segment& s)
{
    using T = typename Point::value_type;
    const auto whole = [](double x) { return static_cast<T>(std::llround(x)); };
    return {{whole(s.a.x), whole(s.a.y)}, {whole(s.b.x), whole(s.b.y)}};
}
template <class Point>
clipping::Segment asSegment(const IntegerLine<Point>& line)
{
    return {{double(line.a.x), double(line.a.y)}, {double(line.b.x), double(line.b.y)}};
}

/// With a rectangle anywhere: OpenCV moves the points to its corner and back.
struct ByRectangle {
    using Line = IntegerLine<cv::Point>;
    using Piece = Line;
    using Box = cv::Rect;
    static Line lineOf(const clipping::Segment& s) { return rounded<cv::Point>(s); }
    static Box boxOf(const clipping::Window& w)
    {
        const auto whole = [](double x) { return static_cast<int>(std::lround(x)); };
        return {whole(w.min.x), whole(w.min.y), whole(w.max.x - w.min.x) + 1,
                whole(w.max.y - w.min.y) + 1};
    }
    static clipping::Segment segmentOf(const Line& line) { return asSegment(line); }
    static std::optional<Piece> clip(Line line, const Box& box)
    {
        return cv::clipLine(box, line.a, line.b) ? std::optional(line) : std::nullopt;
    }
};

/// With a size: the window's corner is the origin, so the data are moved there beforehand.
template <class Point, class Size>
struct BySize {
    using Line = IntegerLine<Point>;
    using Piece = Line;
    using Box = Size;
    static inline Point origin; // of the one window that all benchmark scenes share
    static Line lineOf(const clipping::Segment& s)
    {
        auto line = rounded<Point>(s);
        line.a -= origin, line.b -= origin;
        return line;
    }
    static Box boxOf(const clipping::Window& w)
    {
        const auto window = rounded<Point>({w.min, w.max});
        origin = window.a;
        return {window.b.x - window.a.x + 1, window.b.y - window.a.y + 1};
    }
    static clipping::Segment segmentOf(Line line)
    {
        line.a += origin, line.b += origin;
        return asSegment(line);
    }
    static std::optional<Piece> clip(Line line, const Box& box)
    {
        return cv::clipLine(box, line.a, line.b) ? std::optional(line) : std::nullopt;
    }
};

template <class Library>
Peer row(std::string_view name, std::string_view numbers)
{
    using Lines = PeerLines<Library>;
    return {name, "cohen-sutherland", numbers, Lines::prepare, anywhere, Lines::bytes};
}

} // namespace

std::span<const Peer> openCvPeers()
{
    static const Peer all[] = {
        row<ByRectangle>("OpenCV clipLine(Rect)", "int"),
        row<BySize<cv::Point, cv::Size>>("OpenCV clipLine(Size)", "int"),
        row<BySize<cv::Point2l, cv::Size2l>>("OpenCV clipLine(Size2l)", "int64"),
    };
    return all;
}
