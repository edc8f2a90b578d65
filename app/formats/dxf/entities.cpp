// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/entities.h"

#include "app/formats/dxf/losses.h"

#include <algorithm>
#include <array>

namespace app::dxf {

static void drawNothing(const Entity&) {}

void tellHeight(const Entity& entity, double z)
{
    if (z != 0)
        entity.drawer.report().add(losses::heights);
}

void addCorners(const Entity& entity, const std::vector<Corner>& corners, const CornerStyle& style)
{
    Shape shape{.paint = style.paint, .width = style.width};
    if (!corners.empty())
        shape.paths.push_back(pathOf(corners, style.closed, style.space));
    entity.drawer.add(entity, std::move(shape));
}

// THE CATALOGUE. To read another entity, declare its function in the header, and add a row.
static constexpr std::array entityTypes{
    EntityType{"LINE", drawLine},
    EntityType{"LWPOLYLINE", drawLwPolyline},
    EntityType{"POLYLINE", drawPolyline},
    EntityType{"ARC", drawArc},
    EntityType{"CIRCLE", drawCircle},
    EntityType{"ELLIPSE", drawEllipse},
    EntityType{"SPLINE", drawSpline},
    EntityType{"POINT", drawPoint},
    EntityType{"INSERT", drawInsert},
    EntityType{"TEXT", drawText},
    EntityType{"ATTRIB", drawText},
    EntityType{"MTEXT", drawMText},
    EntityType{"HATCH", drawHatch},
    EntityType{"SOLID", drawSolid},
    EntityType{"TRACE", drawSolid},
    EntityType{"3DFACE", drawFace},
    EntityType{"LEADER", drawLeader},
    EntityType{"DIMENSION", drawDimension},
    EntityType{"ATTDEF", drawDefinition},
    EntityType{"VERTEX", drawNothing}, // without a polyline before it
    EntityType{"SEQEND", drawNothing},
};

const EntityType* findEntityType(std::string_view type)
{
    const auto found = std::ranges::find(entityTypes, type, &EntityType::type);
    return found == entityTypes.end() ? nullptr : &*found;
}

bool isWhole(std::string_view type) { return type != "VERTEX" && type != "SEQEND"; }

} // namespace app::dxf
