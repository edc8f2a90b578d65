// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/affine_map.h"

#include "app/base/finite.h"
#include "app/document/direction.h"

#include <glm/trigonometric.hpp>

#include <cmath>

namespace app {

std::optional<Placement> AffineMap::placement() const
{
    if (x.y != 0 || y.x != 0)
        return std::nullopt;
    const Point scale(x.x, y.y);
    return Placement{scale, to - from * scale};
}

double AffineMap::scale() const { return std::sqrt(std::abs(x.x * y.y - x.y * y.x)); }

bool AffineMap::isFinite() const
{
    return app::isFinite(x) && app::isFinite(y) && app::isFinite(from) && app::isFinite(to);
}

AffineMap translation(const Point& by) { return {.to = by}; }

AffineMap rotation(double degrees, const Point& about)
{
    const Point direction = directionOf(degrees);
    return {direction, {-direction.y, direction.x}, about, about};
}

AffineMap scaling(const Point& factors, const Point& about)
{
    return {{factors.x, 0}, {0, factors.y}, about, about};
}

AffineMap horizontalSkew(double degrees, const Point& about)
{
    return {.y = {-std::tan(glm::radians(degrees)), 1}, .from = about, .to = about};
}

AffineMap verticalSkew(double degrees, const Point& about)
{
    return {.x = {1, -std::tan(glm::radians(degrees))}, .from = about, .to = about};
}

} // namespace app
