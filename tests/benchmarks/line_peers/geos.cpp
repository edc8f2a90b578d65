// SPDX-License-Identifier: GPL-3.0-or-later
#include <geos/geom/Coordinate.h>
#include <geos/geom/CoordinateArraySequence.h>
#include <geos/geom/GeometryFactory.h>
#include <geos/geom/LineString.h>
#include <geos/geom/LinearRing.h>
#include <geos/geom/Polygon.h>
#include <geos/geom/prep/PreparedGeometry.h>
#include <geos/geom/prep/PreparedGeometryFactory.h>
#include <vector>

#include "tests/benchmarks/line_peers/peer.h"

// GEOS with a prepared polygon: lines that it contains and lines that are disjoint from it are
// found by its index, and only the rest is intersected.

namespace {

using namespace geos::geom;

std::unique_ptr<CoordinateSequence> sequenceOf(std::vector<Coordinate> points)
{
    return std::make_unique<CoordinateArraySequence>(std::move(points));
}

class Data : public LinePeerData {
public:
    Data(std::span<const clipping::Segment> lines, const clipping::Area& window)
        : factory_(GeometryFactory::create())
    {
        std::vector<Coordinate> ring;
        for (const auto& p : window.points)
            ring.emplace_back(p.x, p.y);
        ring.push_back(ring.front());
        window_ = factory_->createPolygon(factory_->createLinearRing(sequenceOf(ring)));
        prepared_ = prep::PreparedGeometryFactory::prepare(window_.get());
        for (const auto& [a, b] : lines)
            lines_.push_back(factory_->createLineString(sequenceOf({{a.x, a.y}, {b.x, b.y}})));
    }
    KeptLines clipAll() override
    {
        KeptLines kept;
        for (const auto& line : lines_) {
            if (prepared_->contains(line.get()))
                add(*line, kept);
            else if (prepared_->intersects(line.get()))
                add(*window_->intersection(line.get()), kept);
        }
        return kept;
    }

private:
    static void add(const Geometry& geometry, KeptLines& kept)
    {
        for (std::size_t i = 0; i < geometry.getNumGeometries(); ++i) {
            const double length = geometry.getGeometryN(i)->getLength();
            kept.length += length;
            kept.pieces += length > 0;
        }
    }
    GeometryFactory::Ptr factory_;
    std::unique_ptr<Polygon> window_;
    std::unique_ptr<prep::PreparedGeometry> prepared_;
    std::vector<std::unique_ptr<LineString>> lines_;
};

} // namespace

std::span<const LinePeer> geosLinePeers()
{
    static const LinePeer all[] = {
        {"GEOS, prepared", "libgeos++-dev", true,
         [](std::span<const clipping::Segment> lines, const clipping::Area& window)
             -> std::unique_ptr<LinePeerData> { return std::make_unique<Data>(lines, window); }}};
    return all;
}
