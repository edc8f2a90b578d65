// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/projection.h"

#include "app/base/text.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace app {
namespace {

Point unchanged(const Point& at) { return at; }

// asinh(tan) keeps more digits near the equator than the usual ln(tan(45° + latitude / 2)).
Point mercator(const Point& at)
{
    return {at.x, glm::degrees(std::asinh(std::tan(glm::radians(at.y))))};
}

Point fromMercator(const Point& at)
{
    return {at.x, glm::degrees(std::atan(std::sinh(glm::radians(at.y))))};
}

} // namespace

std::span<const ProjectionKind> projections()
{
    static const std::array all{
        ProjectionKind{Projection::PlateCarree, "plate-carree", unchanged, unchanged,
                       Text::tr("plate carrée")},
        ProjectionKind{Projection::WebMercator, "web-mercator", mercator, fromMercator,
                       Text::tr("Web Mercator")},
    };
    return all;
}

const ProjectionKind& kindOf(Projection projection)
{
    return *std::ranges::find(projections(), projection, &ProjectionKind::projection);
}

} // namespace app
