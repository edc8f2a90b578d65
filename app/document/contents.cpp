// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/contents.h"

#include "app/document/flatten.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace app {

void add(Contents& contents, const Shape& shape, double tolerance)
{
    std::vector<Chord> chords;
    ++contents.shapes;
    contents.paths += shape.paths.size();
    for (const Subpath& path : shape.paths) {
        contents.closedPaths += path.closed;
        contents.curves += std::size_t(std::ranges::count_if(path.segments, &PathSegment::curved));
        flatten(path, tolerance, chords);
    }
    contents.lines += chords.size();
    for (const Chord& chord : chords) {
        const auto& [a, b] = chord.segment;
        contents.length += std::hypot(b.x - a.x, b.y - a.y);
        const clipping::Window box{glm::min(a, b), glm::max(a, b)};
        contents.bounds = contents.bounds
                              ? clipping::Window{glm::min(contents.bounds->min, box.min),
                                                 glm::max(contents.bounds->max, box.max)}
                              : box;
    }
}

Contents contentsOf(const Sheet& sheet)
{
    Contents contents;
    const double tolerance = usualTolerance(sheet.page);
    for (const Shape& shape : sheet.shapes)
        add(contents, shape, tolerance);
    return contents;
}

} // namespace app
