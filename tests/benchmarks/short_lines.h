// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document_builder.h"

#include <cmath>
#include <random>

/// Many scattered lines of 3 to 17 pixels on a page of 1280 x 800, with one clip window.
inline app::Document shortLines(int count)
{
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> x(0, 1280), y(0, 800), length(3, 17), angle(0, 2 * M_PI);
    app::DocumentBuilder builder;
    builder.open({.name = "Lines"});
    const app::StyleEntry style = builder.style({.stroke = app::Colour{}});
    for (int i = 0; i < count; ++i) {
        const app::Point a(x(random), y(random));
        const double l = length(random), t = angle(random);
        builder.addLine({a, a + l * app::Point(std::cos(t), std::sin(t))}, style);
    }
    builder.close();
    return builder.take({{0, 0}, {1280, 800}, {1280, app::Unit::Px}, {800, app::Unit::Px}}, {},
                        {{{.shape = app::RectangleShape{{{320, 200}, {960, 600}}}}}});
}
