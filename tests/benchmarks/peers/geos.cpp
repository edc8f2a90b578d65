// SPDX-License-Identifier: GPL-3.0-or-later
#include <geos/geom/Coordinate.h>
#include <geos/geom/CoordinateArraySequence.h>
#include <geos/geom/GeometryFactory.h>
#include <geos/geom/LineString.h>
#include <geos/operation/intersection/Rectangle.h>
#include <geos/operation/intersection/RectangleIntersection.h>

#include "tests/benchmarks/peers/lines.h"

// GEOS' RectangleIntersection (GEOSClipByRect in C), on one LineString a segment. It allocates
// every result; we copy it to a flat buffer and give it back at once.

namespace {

using geos::geom::LineString;
using geos::operation::intersection::Rectangle;

struct Geos {
    using Line = std::unique_ptr<LineString>;
    using Piece = clipping::Segment;
    using Box = Rectangle;

    static Line lineOf(const clipping::Segment& s)
    {
        auto ends = std::make_unique<geos::geom::CoordinateArraySequence>(std::size_t{2});
        ends->setAt({s.a.x, s.a.y}, 0);
        ends->setAt({s.b.x, s.b.y}, 1);
        return geos::geom::GeometryFactory::getDefaultInstance()->createLineString(std::move(ends));
    }
    static Box boxOf(const clipping::Window& w) { return {w.min.x, w.min.y, w.max.x, w.max.y}; }
    static clipping::Segment segmentOf(const LineString& line)
    {
        const auto &a = line.getCoordinateN(0), &b = line.getCoordinateN(1);
        return {{a.x, a.y}, {b.x, b.y}};
    }
    static clipping::Segment segmentOf(const Line& line) { return segmentOf(*line); }
    static clipping::Segment segmentOf(const Piece& piece) { return piece; }
    static std::optional<Piece> clip(const Line& line, const Box& box)
    {
        const auto common = geos::operation::intersection::RectangleIntersection::clip(*line, box);
        const auto* piece = dynamic_cast<const LineString*>(common.get());
        return piece && !piece->isEmpty() ? std::optional(segmentOf(*piece)) : std::nullopt;
    }
};

} // namespace

std::span<const Peer> geosPeers()
{
    using Lines = PeerLines<Geos>;
    static const Peer all[] = {{"GEOS RectangleIntersection", "cohen-sutherland", "double",
                                Lines::prepare, doubleEnds, Lines::bytes + 250}};
    return all;
}
