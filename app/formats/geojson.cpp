// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/formats/geojson/read_geojson.h"
#include "app/formats/geojson/write_geojson.h"

namespace app {

Format geojsonFormat()
{
    return {.key = "geojson",
            .name = Text::tr("GeoJSON map"),
            .read = [](QIODevice& in) { return geojson::read(in, {}); },
            .write = geojson::write,
            .holds = Holds::Polygons,
            .limits = Text::tr("%1 bytes, %2 layers (further layers become one)")
                          .arg(countText(std::size_t(geojson::mostBytes)),
                               countText(Containers::mostLayers)),
            .purpose = Text::tr("maps"),
            .takes = {.precision = true, .projection = true},
            .readWith = geojson::read};
}

} // namespace app
