// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include "tests/benchmarks/area_peers/peer.h"

// Boost.Geometry, for polygons that do not cross themselves: it refuses all others.

namespace {

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;
using Polygon = bg::model::polygon<Point>;

Polygon polygonOf(const clipping::Area& area)
{
    Polygon polygon;
    for (const auto& p : area.points)
        polygon.outer().push_back({p.x, p.y});
    bg::correct(polygon);
    return polygon;
}

class Data : public AreaPeerData {
public:
    Data(std::span<const clipping::Area> areas, const clipping::Area& window)
        : window_(polygonOf(window))
    {
        for (const auto& area : areas)
            areas_.push_back(polygonOf(area));
    }
    double clipAll() override
    {
        double sum = 0;
        for (const Polygon& area : areas_) {
            bg::model::multi_polygon<Polygon> left;
            bg::intersection(area, window_, left);
            sum += bg::area(left);
        }
        return sum;
    }

private:
    std::vector<Polygon> areas_;
    Polygon window_;
};

} // namespace

std::span<const AreaPeer> boostGeometryAreaPeers()
{
    static const AreaPeer all[] = {
        {"Boost.Geometry", "libboost-dev", false,
         [](std::span<const clipping::Area> areas, const clipping::Area& window)
             -> std::unique_ptr<AreaPeerData> { return std::make_unique<Data>(areas, window); }}};
    return all;
}
