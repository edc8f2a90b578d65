// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>

#include "tests/app/document/sheet.h"

constexpr clipping::Window paper{{100, 100}, {300, 250}};

/// Random lines; every fourth one is steep enough for published KWC to lose it.
inline app::Sheet sheetOf(std::size_t lines)
{
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> x(0, 400), y(0, 400);
    app::Sheet sheet;
    sheet.window = paper;
    for (std::size_t i = 0; i < lines; ++i) {
        const app::Point a(x(random), y(random)), b(x(random), y(random));
        app::Shape line;
        line.paths = {{a, {{i % 4 ? b : app::Point(a.x + 0.5, b.y)}}}};
        sheet.shapes.push_back(std::move(line));
    }
    return sheet;
}
