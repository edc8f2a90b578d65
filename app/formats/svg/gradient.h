// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/transform.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace app::svg {

/// Red, green, blue and alpha, each from 0 to 1; not multiplied by alpha.
using Rgba = std::array<double, 4>;

struct GradientStop {
    double at = 0; ///< 0 to 1
    Rgba colour{};
};

/// The colours along a gradient, from 0 to 1. `at` never decreases; never empty where it is used.
using GradientStops = std::vector<GradientStop>;

/// The colour at t, clamped to 0 … 1, as SVG blends it: linearly, between the nearest stops.
Rgba colourAt(const GradientStops& stops, double t);

/// How a gradient lies in its own coordinates, with the meaning of SVG's attributes.
struct GradientShape {
    enum class Spread : std::uint8_t { Pad, Reflect, Repeat };

    bool radial = false;
    bool inBox = true; ///< in shares of the painted shape's box
    Matrix transform{};
    Spread spread = Spread::Pad;
    Point from{}, to{};                 ///< linear: the ends; radial: the focus and the centre
    double focusRadius = 0, radius = 0; ///< radial
};

/// The place along the gradient, from 0 to 1, of a point in its own coordinates. Empty for a
/// gradient of no length, which has the colour of its last stop.
std::optional<double> placeAlong(const GradientShape& shape, const Point& point);

} // namespace app::svg
