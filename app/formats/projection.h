// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <QString>

#include <span>
#include <string_view>

namespace app {

/// How degrees of longitude and latitude become a plane.
enum class Projection : std::uint8_t { PlateCarree, WebMercator };

struct ProjectionKind {
    Projection projection;
    std::string_view key;              ///< of the command line
    Point (*onPlane)(const Point& at); ///< longitude, latitude -> x, y; degrees, y up
    Point (*onGlobe)(const Point& at); ///< the inverse
    QString name;                      ///< "Web Mercator", translated
};

// THE CATALOGUE. To add a projection: add its row.
std::span<const ProjectionKind> projections(); ///< the first one is the usual one
const ProjectionKind& kindOf(Projection projection);

/// In degrees: maps end there (EPSG:3857), where Web Mercator is a square. The source of the
/// formulas: J. P. Snyder, Map Projections: A Working Manual, 1987, pages 41 and 91.
constexpr double farthestLatitude = 85.05112877980659;

} // namespace app
