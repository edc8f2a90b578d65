// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/multi_linestring.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include "tests/benchmarks/line_peers/peer.h"

// Boost.Geometry, for polygons that do not cross themselves. It has no prepared polygons, so lines
// off the polygon's bounding box are left out first.

namespace {

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;
using Line = bg::model::linestring<Point>;
using Lines = bg::model::multi_linestring<Line>;
using Polygon = bg::model::polygon<Point>;
using Box = bg::model::box<Point>;

class Data : public LinePeerData {
public:
    Data(std::span<const clipping::Segment> lines, const clipping::Area& window)
    {
        for (const auto& p : window.points)
            window_.outer().push_back({p.x, p.y});
        bg::correct(window_);
        bg::envelope(window_, box_);
        for (const auto& [a, b] : lines)
            lines_.push_back({{a.x, a.y}, {b.x, b.y}});
    }
    KeptLines clipAll() override
    {
        KeptLines kept;
        for (const Line& line : lines_) {
            if (bg::disjoint(bg::return_envelope<Box>(line), box_))
                continue;
            Lines left;
            bg::intersection(line, window_, left);
            for (const Line& piece : left) {
                const double length = bg::length(piece);
                kept.length += length;
                kept.pieces += length > 0;
            }
        }
        return kept;
    }

private:
    Polygon window_;
    Box box_;
    std::vector<Line> lines_;
};

} // namespace

std::span<const LinePeer> boostGeometryLinePeers()
{
    static const LinePeer all[] = {
        {"Boost.Geometry", "libboost-dev", false,
         [](std::span<const clipping::Segment> lines, const clipping::Area& window)
             -> std::unique_ptr<LinePeerData> { return std::make_unique<Data>(lines, window); }}};
    return all;
}
