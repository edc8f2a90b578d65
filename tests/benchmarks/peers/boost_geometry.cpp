// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/segment.hpp>

#include "tests/benchmarks/peers/lines.h"

// Boost.Geometry: its documented intersection, and the Liang-Barsky beneath it, which is not
// documented but is what it could do at best.

namespace {

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;
using BoostBox = bg::model::box<Point>;
using BoostSegment = bg::model::segment<Point>;
using Linestring = bg::model::linestring<Point>;

Point pointOf(const glm::dvec2& p) { return {p.x, p.y}; }
glm::dvec2 vectorOf(const Point& p) { return {p.x(), p.y()}; }

struct Common {
    using Box = BoostBox;
    using Line = BoostSegment;
    static Box boxOf(const clipping::Window& w) { return {pointOf(w.min), pointOf(w.max)}; }
    static Line lineOf(const clipping::Segment& s) { return {pointOf(s.a), pointOf(s.b)}; }
    static clipping::Segment segmentOf(const BoostSegment& s)
    {
        return {vectorOf(s.first), vectorOf(s.second)};
    }
};

struct Strategy : Common {
    using Piece = BoostSegment;
    static std::optional<Piece> clip(BoostSegment line, const Box& box)
    {
        const bg::strategy::intersection::liang_barsky<Box, Point> liangBarsky;
        bg::model::referring_segment<Point> ends(line.first, line.second);
        bool newA, newB;
        return liangBarsky.clip_segment(box, ends, newA, newB) ? std::optional(line) : std::nullopt;
    }
};

struct Intersection : Common {
    using Piece = BoostSegment;
    static std::optional<Piece> clip(const BoostSegment& line, const Box& box)
    {
        static std::vector<Linestring> pieces; // keeps its room
        pieces.clear();
        bg::intersection(line, box, pieces);
        if (pieces.empty())
            return {};
        return Piece(pieces[0].front(), pieces[0].back());
    }
};

} // namespace

std::span<const Peer> boostGeometryPeers()
{
    using Inner = PeerLines<Strategy>;
    using Outer = PeerLines<Intersection>;
    static const Peer all[] = {
        {"Boost.Geometry clip_segment", "liang-barsky", "double", Inner::prepare, doubleEnds,
         Inner::bytes},
        {"Boost.Geometry intersection", "liang-barsky", "double", Outer::prepare, doubleEnds,
         Outer::bytes},
    };
    return all;
}
