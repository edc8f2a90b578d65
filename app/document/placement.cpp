// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/placement.h"

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

} // namespace app
