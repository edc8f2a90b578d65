// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/dxf/curves.h"
#include "app/formats/dxf/drawer.h"

namespace app::dxf {

/// A row of the catalogue of entities.
struct EntityType {
    std::string_view type; ///< the value of code 0
    void (*draw)(const Entity& entity);
};

const EntityType* findEntityType(std::string_view type); ///< null: it is not read
/// Whether an entity of this type is more than a part of the one before it.
bool isWhole(std::string_view type);

/// Reports a shape that is not in the plane.
void tellHeight(const Entity& entity, double z);

/// How a polyline is drawn.
struct CornerStyle {
    bool closed = false;
    Space space{};
    Paint paint = Paint::Stroke;
    double width = 0; ///< of its line on the page; 0: as the pen says
};
void addCorners(const Entity& entity, const std::vector<Corner>& corners, const CornerStyle& style);

// Each function draws entities of the type that it is called after. They throw BadValue.
void drawLine(const Entity& entity);
void drawPoint(const Entity& entity);
void drawCircle(const Entity& entity);
void drawArc(const Entity& entity);
void drawEllipse(const Entity& entity);
void drawSolid(const Entity& entity); ///< SOLID and TRACE
void drawFace(const Entity& entity);  ///< 3DFACE
void drawLwPolyline(const Entity& entity);
void drawPolyline(const Entity& entity); ///< with the vertices that follow
void drawSpline(const Entity& entity);
void drawLeader(const Entity& entity);
void drawHatch(const Entity& entity);
void drawInsert(const Entity& entity);
void drawDimension(const Entity& entity);
void drawText(const Entity& entity);       ///< TEXT and ATTRIB
void drawDefinition(const Entity& entity); ///< ATTDEF: each insertion has its own text
void drawMText(const Entity& entity);

} // namespace app::dxf
