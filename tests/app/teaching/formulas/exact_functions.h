// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/formulas/evaluate.h"
#include "clipping/exact/turn.h"

namespace app::formulas {

/// The library's own exact functions, which only tests may include.
inline constexpr ExactFunctions exactFunctions{
    [](const clipping::Segment& s, double x, double y) {
        const auto order = clipping::orderInIntegers(s.a.x, s.a.y, s.b.x, s.b.y, x, y);
        return order < 0 ? -1 : order > 0 ? 1 : 0;
    },
    [](const clipping::Segment& s, double x) {
        return clipping::crossingInIntegers<double>(s.a.x, s.a.y, s.b.x, s.b.y, x);
    },
    [](const clipping::Segment& s, const glm::dvec2& point) {
        return clipping::turnInIntegers(s.a, s.b, s.a, point);
    }};

} // namespace app::formulas
