// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/entities.h"
#include "app/formats/dxf/limits.h"
#include "app/formats/dxf/losses.h"
#include "app/formats/dxf/spline.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace app::dxf {
namespace {

/// Reads the outlines of a hatch: a list in which the meaning of a code depends on those before it.
class HatchReader {
public:
    explicit HatchReader(const Entity& entity)
        : drawer_(entity.drawer), pairs_(entity.record.pairs), space_(entity.plane())
    {
        elevation_ = entity.record.number(30);
    }

    std::vector<Subpath> read()
    {
        constexpr int outlineCount = 91, outlineKind = 92;
        while (at_ < pairs_.size() && pairs_[at_].code != outlineCount)
            ++at_;
        std::vector<Subpath> outlines;
        while (at_ < pairs_.size()) {
            const auto& [code, value] = pairs_[at_++];
            if (code == 75) // what follows is about the pattern
                break;
            if (code != outlineKind)
                continue;
            constexpr int polyline = 2;
            if ((integerOf(value) & polyline) != 0)
                outlines.push_back(polylineOutline());
            else
                addEdges(outlines);
        }
        std::erase_if(outlines, [](const Subpath& path) { return path.segments.empty(); });
        return outlines;
    }

private:
    bool is(int code) const { return at_ < pairs_.size() && pairs_[at_].code == code; }
    double number(int code, double otherwise = 0)
    {
        return is(code) ? numberOf(pairs_[at_++].value) : otherwise;
    }
    int integer(int code, int otherwise = 0)
    {
        return is(code) ? integerOf(pairs_[at_++].value) : otherwise;
    }
    glm::dvec3 point(int code)
    {
        const double x = number(code), y = number(code + 10);
        return {x, y, elevation_};
    }
    glm::dvec3 vector(int code)
    {
        const double x = number(code), y = number(code + 10);
        return {x, y, 0};
    }

    Subpath polylineOutline()
    {
        integer(72); // whether there are bulges
        const bool closed = integer(73, 1) != 0;
        integer(93);
        std::vector<Corner> corners;
        while (is(10)) {
            Corner corner{point(10)};
            corner.bulge = number(42);
            corners.push_back(corner);
        }
        return pathOf(corners, closed, space_);
    }

    // Edges that meet make one path.
    void addEdges(std::vector<Subpath>& outlines)
    {
        integer(93);
        Subpath outline;
        while (is(72)) {
            const Subpath edge = edgeOf(integer(72));
            if (edge.segments.empty())
                continue;
            constexpr double near = 1e-6;
            const bool meets = !outline.segments.empty()
                               && glm::distance(outline.segments.back().to, edge.start)
                                      <= near * (1 + glm::length(edge.start));
            if (!meets) {
                finish(std::move(outline), outlines);
                outline = {edge.start, {}, false};
            }
            outline.segments.insert(outline.segments.end(), edge.segments.begin(),
                                    edge.segments.end());
        }
        finish(std::move(outline), outlines);
    }
    static void finish(Subpath outline, std::vector<Subpath>& outlines)
    {
        outline.closed = true; // as its area is
        if (!outline.segments.empty())
            outlines.push_back(std::move(outline));
    }

    Subpath edgeOf(int kind)
    {
        enum Kind { Line = 1, Arc, Ellipse, Curve };
        if (kind == Line) {
            const glm::dvec3 a = point(10), b = point(11);
            return {onPage(space_(a)), {{onPage(space_(b))}}, false};
        }
        if (kind == Arc) {
            const glm::dvec3 centre = point(10);
            const double radius = number(40);
            return arcEdge(centre, {radius, 0, 0}, {0, radius, 0});
        }
        if (kind == Ellipse) {
            const glm::dvec3 centre = point(10), major = vector(11);
            const double ratio = number(40, 1);
            return arcEdge(centre, major, glm::dvec3(-major.y, major.x, 0) * ratio);
        }
        if (kind == Curve)
            return splineEdge();
        throw BadValue{};
    }

    // Angles are in degrees; they count clockwise if the edge does.
    Subpath arcEdge(const glm::dvec3& centre, const glm::dvec3& axis1, const glm::dvec3& axis2)
    {
        const double from = number(50), to = number(51);
        const double side = integer(73, 1) != 0 ? 1 : -1;
        EllipseArc arc = arcOnPage(space_, centre, axis1, axis2 * side);
        double sweep = std::remainder(to - from, 360);
        if (sweep <= 1e-9)
            sweep += 360;
        arc.angle = glm::radians(std::remainder(from, 360));
        arc.sweep = glm::radians(sweep);
        Subpath path = pathOf(arc);
        path.closed = false;
        return path;
    }

    Subpath splineEdge()
    {
        Spline spline{std::size_t(std::clamp(integer(94, 3), 1, highestDegree))};
        integer(73), integer(74), integer(95), integer(96);
        while (is(40))
            spline.knots.push_back(number(40));
        while (is(10)) {
            const Point p = onPage(space_(point(10)));
            const double weight = number(42, 1);
            spline.points.emplace_back(p * weight, weight);
        }
        if (spline.points.size() > mostSplinePoints || !spline.isValid())
            throw BadValue{};
        return pathOf(spline, drawer_.units(splineTolerance));
    }

    Drawer& drawer_;
    const std::vector<Pair>& pairs_;
    Space space_;
    double elevation_ = 0;
    std::size_t at_ = 0;
};

} // namespace

void drawHatch(const Entity& entity)
{
    const Record& record = entity.record;
    Report& report = entity.drawer.report();
    tellHeight(entity, record.number(30));
    Shape shape{HatchReader(entity).read()};
    const bool solid = record.integer(70) == 1;
    if (record.integer(450) == 1)
        report.add(losses::gradient);
    else if (!solid)
        report.add(losses::hatchPattern);
    shape.paint = solid ? Paint::Fill : Paint::Stroke;
    entity.drawer.add(entity, std::move(shape));
}

} // namespace app::dxf
