// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Shared by the polygon tests: every form, and random polygons.

#include <QTest>

#include "tests/clipping/polygon/contract.h"
#include "tests/clipping/scenes.h"

/// One column, every form for polygons of the catalogue: `uses`, and whether it decides exactly.
inline void everyPolygonForm()
{
    QTest::addColumn<const PolygonUses*>("uses");
    QTest::addColumn<bool>("decidesExactly");
    for (const clipping::Algorithm& a : clipping::algorithms()) {
        const bool exact = a.key != std::string_view("cyrus-beck");
        if (a.polygon)
            QTest::newRow(a.key.data()) << a.polygon << exact;
        if (a.polygonBySearch)
            QTest::addRow("%s, searched", a.key.data()) << a.polygonBySearch << exact;
    }
}

/// A convex polygon of up to n corners near the origin, as large as `size`; one of four is slim, to
/// a width of 2^-40.
inline clipping::ConvexPolygon somePolygon(RandomNumbers& random, int n, double size)
{
    const double turn = random.uniform(0, 6.3), centreX = random.uniform(-1, 1);
    const double width = random.integer(0, 3) == 0 ? std::exp2(-random.uniform(0, 40)) : 1;
    std::vector<glm::dvec2> points;
    for (int i = 0; i < n; ++i) {
        const double angle = random.uniform(0, 6.283185307179586);
        const double x = std::cos(angle) + centreX, y = std::sin(angle) * width;
        points.push_back({size * (x * std::cos(turn) - y * std::sin(turn)),
                          size * (x * std::sin(turn) + y * std::cos(turn))});
    }
    return hullOf(points);
}
