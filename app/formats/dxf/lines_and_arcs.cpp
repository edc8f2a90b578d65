// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/recipe_outline.h"
#include "app/formats/dxf/curves.h"
#include "app/formats/dxf/entities.h"
#include "app/formats/dxf/losses.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>
#include <numbers>

namespace app::dxf {
namespace {

constexpr double degreesOfTurn = 360;

double sweepOf(double from, double to, double whole)
{
    const double sweep = std::remainder(to - from, whole);
    return sweep > 1e-9 ? sweep : sweep + whole;
}

// An ellipse that lies along the axes of the page can be edited as one.
void addEllipse(const Entity& entity, const EllipseArc& whole)
{
    const auto& [centre, a, b, angle, sweep] = whole;
    const bool plain = a.y == 0 && b.x == 0, turned = a.x == 0 && b.y == 0;
    if (!plain && !turned) {
        entity.drawer.add(entity, {{pathOf(whole)}});
        return;
    }
    const EllipseRecipe recipe{centre, plain ? Point(std::abs(a.x), std::abs(b.y))
                                             : Point(std::abs(b.x), std::abs(a.y))};
    entity.drawer.add(entity, {.paths = {*outlineOf(recipe)}, .recipe = recipe});
}

// The radius along the x axis of the entity's plane. One of 0 makes a point.
void drawRound(const Entity& entity, double from, double sweep)
{
    const Record& record = entity.record;
    const glm::dvec3 centre = record.point(10);
    const double radius = std::abs(record.number(40));
    tellHeight(entity, centre.z);
    EllipseArc arc = arcOnPage(entity.plane(), centre, {radius, 0, 0}, {0, radius, 0});
    arc.angle = glm::radians(std::remainder(from, degreesOfTurn));
    arc.sweep = glm::radians(sweep);
    if (radius == 0)
        entity.drawer.add(entity, {{Subpath{arc.centre, {}, false}}});
    else if (sweep == degreesOfTurn)
        addEllipse(entity, arc);
    else
        entity.drawer.add(entity, {{pathOf(arc)}});
}

} // namespace

void drawLine(const Entity& entity)
{
    const glm::dvec3 a = entity.record.point(10), b = entity.record.point(11);
    tellHeight(entity, a.z != 0 ? a.z : b.z);
    entity.drawer.addLine(entity, {onPage(entity.place.space(a)), onPage(entity.place.space(b))});
}

void drawPoint(const Entity& entity)
{
    const glm::dvec3 at = entity.record.point(10);
    tellHeight(entity, at.z);
    entity.drawer.add(entity, {{Subpath{onPage(entity.place.space(at)), {}, false}}});
}

void drawCircle(const Entity& entity) { drawRound(entity, 0, degreesOfTurn); }

void drawArc(const Entity& entity)
{
    const double from = entity.record.number(50), to = entity.record.number(51);
    const double sweep = sweepOf(from, to, degreesOfTurn);
    drawRound(entity, from, std::abs(sweep - degreesOfTurn) < 1e-9 ? degreesOfTurn : sweep);
}

void drawEllipse(const Entity& entity)
{
    const Record& record = entity.record;
    constexpr double turn = 2 * std::numbers::pi;
    const glm::dvec3 centre = record.point(10), major = record.point(11);
    const glm::dvec3 normal = planeOf(record.point(210, {0, 0, 1})).axes[2];
    const glm::dvec3 minor = glm::cross(normal, major) * record.number(40, 1);
    tellHeight(entity, centre.z);
    EllipseArc arc = arcOnPage(entity.place.space, centre, major, minor);
    const double from = record.number(41), to = record.number(42, turn);
    arc.angle = std::remainder(from, turn);
    arc.sweep = sweepOf(from, to, turn);
    if (major == glm::dvec3(0))
        entity.drawer.report().add(losses::sizeless);
    else if (std::abs(arc.sweep - turn) < 1e-9)
        addEllipse(entity, {arc.centre, arc.axis1, arc.axis2, 0, turn});
    else
        entity.drawer.add(entity, {{pathOf(arc)}});
}

void drawSolid(const Entity& entity)
{
    const Record& record = entity.record;
    const Space plane = entity.plane();
    std::vector<Corner> corners;
    for (const int code : {10, 11, 13, 12}) // as a Z
        if (record.has(code))
            corners.push_back({record.point(code)});
    addCorners(entity, corners, {.closed = true, .space = plane, .paint = Paint::Fill});
}

void drawFace(const Entity& entity)
{
    const Record& record = entity.record;
    std::vector<Corner> corners;
    for (const int code : {10, 11, 12, 13})
        if (record.has(code))
            corners.push_back({record.point(code)});
    addCorners(entity, corners, {.closed = true, .space = entity.place.space});
}

} // namespace app::dxf
