// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/measure.h"

#include "app/document/flatten.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace app {

void add(Measure& measure, const Shape& shape, double tolerance)
{
    std::vector<Chord> chords;
    ++measure.shapes;
    measure.paths += shape.paths.size();
    for (const Path& path : shape.paths) {
        measure.closedPaths += path.closed;
        measure.curves += std::size_t(std::ranges::count_if(path.stretches, &Stretch::curved));
        flatten(path, tolerance, chords);
    }
    measure.lines += chords.size();
    for (const Chord& chord : chords) {
        const auto& [a, b] = chord.segment;
        measure.length += std::hypot(b.x - a.x, b.y - a.y);
        const clipping::Window box{glm::min(a, b), glm::max(a, b)};
        measure.bounds = measure.bounds ? clipping::Window{glm::min(measure.bounds->min, box.min),
                                                           glm::max(measure.bounds->max, box.max)}
                                        : box;
    }
}

Measure measureOf(const Sheet& sheet)
{
    Measure measure;
    const double tolerance = usualTolerance(sheet.page);
    for (const Shape& shape : sheet.shapes)
        add(measure, shape, tolerance);
    return measure;
}

} // namespace app
