// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/affine_map.h"

#include "app/base/finite.h"
#include "app/document/direction.h"

#include <glm/trigonometric.hpp>

#include <cmath>

namespace app {
namespace {

bool addsNothing(double offset) { return offset == 0 && std::signbit(offset); }

// An offset of -0 is skipped: a negative scale would turn it into 0, and 0 + -0 is not -0.
double then(double offset, double scale, double next)
{
    return addsNothing(offset) ? next : offset * scale + next;
}

} // namespace

Point Placement::operator()(const Point& p) const { return p * scale + offset; }

Placement Placement::then(const Placement& next) const
{
    if (isIdentity() || next.isIdentity())
        return isIdentity() ? next : *this;
    return {scale * next.scale,
            {app::then(offset.x, next.scale.x, next.offset.x),
             app::then(offset.y, next.scale.y, next.offset.y)}};
}

bool Placement::isIdentity() const
{
    return scale == Point(1, 1) && addsNothing(offset.x) && addsNothing(offset.y);
}

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
