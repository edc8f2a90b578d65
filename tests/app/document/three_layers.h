// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/app/document/sheet.h"

inline app::Shape line(app::Point a, app::Point b, std::uint32_t layer)
{
    app::Shape shape;
    shape.paths.push_back({a, {{b}}, false});
    shape.layer = layer;
    return shape;
}

/// Three layers, "a" to "c", with so many lines each.
inline app::Sheet threeLayers(std::size_t perLayer)
{
    app::Sheet result;
    result.layers = {{"a"}, {"b"}, {"c"}};
    for (std::uint32_t layer = 0; layer < 3; ++layer)
        for (std::size_t i = 0; i < perLayer; ++i)
            result.shapes.push_back(line({i, layer}, {i + 5, layer + 1}, layer));
    return result;
}
