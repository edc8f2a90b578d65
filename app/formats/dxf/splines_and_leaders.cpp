// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/entities.h"
#include "app/formats/dxf/limits.h"
#include "app/formats/dxf/losses.h"
#include "app/formats/dxf/spline.h"

namespace app::dxf {
namespace {

constexpr int closedFlag = 1, periodicFlag = 2;

Point directionOnPage(const Entity& entity, int code)
{
    return entity.record.has(code) ? onPage(entity.place.space.direction(entity.record.point(code)))
                                   : Point(0);
}

std::vector<Point> pointsOnPage(const Entity& entity, int code)
{
    std::vector<Point> points;
    for (const glm::dvec3& p : pointsOf(entity.record, code))
        points.push_back(onPage(entity.place.space(p)));
    return points;
}

} // namespace

void drawSpline(const Entity& entity)
{
    const Record& record = entity.record;
    const int flags = record.integer(70), degree = record.integer(71, 3);
    const std::vector<Point> points = pointsOnPage(entity, 10);
    if (points.empty()) {
        const std::vector<Point> through = pointsOnPage(entity, 11);
        if (through.size() > mostSplinePoints || through.empty())
            throw BadValue{};
        entity.drawer.add(entity,
                          {{pathThrough(through, directionOnPage(entity, 12),
                                        directionOnPage(entity, 13), (flags & closedFlag) != 0)}});
        return;
    }
    if (degree < 1 || degree > highestDegree || points.size() > mostSplinePoints)
        throw BadValue{};
    Spline spline{std::size_t(degree), numbersOf(record, 40)};
    const std::vector<double> weights = numbersOf(record, 41);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double weight = weights.size() == points.size() ? weights[i] : 1;
        spline.points.emplace_back(points[i] * weight, weight);
    }
    if (!spline.isValid())
        throw BadValue{};
    Subpath path = pathOf(spline, entity.drawer.units(splineTolerance));
    path.closed = (flags & (closedFlag | periodicFlag)) != 0 && !path.segments.empty()
                  && path.segments.back().to == path.start;
    entity.drawer.add(entity, {{std::move(path)}});
}

void drawLeader(const Entity& entity)
{
    const Record& record = entity.record;
    const std::vector<Point> points = pointsOnPage(entity, 10);
    if (points.empty())
        throw BadValue{};
    Subpath path{points.front(), {}, false};
    if (record.integer(72) == 1 && points.size() <= mostSplinePoints)
        path = pathThrough(points, Point(0), Point(0), false);
    else
        for (std::size_t i = 1; i < points.size(); ++i)
            path.segments.push_back({points[i]});
    if (record.integer(71, 1) == 1)
        entity.drawer.report().add(losses::arrowhead);
    entity.drawer.add(entity, {{std::move(path)}});
}

} // namespace app::dxf
