// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>

#include "tests/benchmarks/peers/lines.h"

// CGAL's intersection of a segment and an Iso_rectangle_2: the ranges of the parameter between
// parallel edges, as in Liang-Barsky; with plain doubles, and with exact predicates.

namespace {

template <class Kernel>
struct Cgal {
    using Point = typename Kernel::Point_2;
    using Line = typename Kernel::Segment_2;
    using Piece = Line;
    using Box = typename Kernel::Iso_rectangle_2;

    static Line lineOf(const clipping::Segment& s) { return {{s.a.x, s.a.y}, {s.b.x, s.b.y}}; }
    static Box boxOf(const clipping::Window& w)
    {
        return {Point(w.min.x, w.min.y), Point(w.max.x, w.max.y)};
    }
    static clipping::Segment segmentOf(const Line& line)
    {
        return {{line.source().x(), line.source().y()}, {line.target().x(), line.target().y()}};
    }
    static std::optional<Piece> clip(const Line& line, const Box& box)
    {
        const auto common = CGAL::intersection(box, line);
        if (!common)
            return {};
        if (const Line* piece = boost::get<Line>(&*common))
            return *piece;
        const Point& contact = boost::get<Point>(*common);
        return Line(contact, contact);
    }
};

template <class Kernel>
Peer row(std::string_view name)
{
    using Lines = PeerLines<Cgal<Kernel>>;
    return {name, "liang-barsky", "double", Lines::prepare, doubleEnds, Lines::bytes};
}

} // namespace

std::span<const Peer> cgalPeers()
{
    static const Peer all[] = {
        row<CGAL::Simple_cartesian<double>>("CGAL intersection, Simple_cartesian"),
        row<CGAL::Exact_predicates_inexact_constructions_kernel>("CGAL intersection, Epick"),
    };
    return all;
}
