// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmarks/clip/map.h"

#include "app/document/flatten.h"
#include "app/formats/format.h"

#include <glm/common.hpp>

#include "tests/app/document/sheet.h"

namespace {

constexpr const char* file = "/usr/share/openclipart/svg/geography/world_map_02.svg";

Map read()
{
    const auto imported = app::readFile(file);
    if (!imported)
        return {"no map: " + imported.error.toStdString() + " (Debian: openclipart-svg)", {}, {}};
    Map map{std::string(file) + " (Debian: openclipart-svg)", {}, {}};
    const app::Sheet sheet = app::sheetOf(imported.value->document);
    std::vector<app::Chord> chords;
    for (const app::Shape& shape : sheet.shapes)
        for (const app::Subpath& path : shape.paths)
            flatten(path, app::usualTolerance(sheet.page), chords);
    for (const app::Chord& chord : chords) {
        const auto [a, b] = chord.segment;
        if (map.segments.empty())
            map.around = {a, a};
        map.around = {glm::min(map.around.min, glm::min(a, b)),
                      glm::max(map.around.max, glm::max(a, b))};
        map.segments.push_back(chord.segment);
    }
    return map;
}

} // namespace

const Map& realMap()
{
    static const Map map = read();
    return map;
}
