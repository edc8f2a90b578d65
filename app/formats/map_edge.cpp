// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/map_edge.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/document/hidden_objects.h"
#include "app/formats/y_up.h"

#include <cmath>

namespace app {
namespace {

constexpr double farthestLongitude = 180;
constexpr double edgeSlack = 1e-9; // degrees, for the roundings of a place at the edge

std::size_t positionsOutside(const Document& document, const WriteOptions& options)
{
    const double height = heightOfPlane(document.page(), options);
    const ProjectionKind& projection = kindOf(options.projection);
    const ObjectRanges hidden = hiddenObjects(document);
    std::size_t count = 0;
    const Objects& objects = document.objects();
    objects.forEach(0, objects.size(), [&](std::size_t i, const ObjectView& object) {
        if (hidden.contains(i))
            return;
        object.path().forEachPoint([&](const Point& p) {
            const Point at = projection.onGlobe({p.x, height - p.y});
            count += std::abs(at.x) > farthestLongitude + edgeSlack
                     || std::abs(at.y) > farthestLatitude + edgeSlack;
        });
    });
    return count;
}

} // namespace

QStringList outsideMap(const Document& document, const Format& format, const WriteOptions& options)
{
    if (!format.takes.projection || options.projection == Projection::PlateCarree)
        return {};
    const std::size_t count = positionsOutside(document, options);
    if (count == 0)
        return {};
    const QString what =
        count == 1 ? Text::tr("1 position lies outside the map and is written as it is")
                   : Text::tr("%1 positions lie outside the map and are written as they are")
                         .arg(countText(count));
    return {Text::tr("%1: %2 ends at %3° of latitude and %4° of longitude")
                .arg(what, kindOf(options.projection).name, numberText(farthestLatitude, 2),
                     numberText(farthestLongitude, 0))};
}

} // namespace app
