// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/contents.h"

#include "app/document/flatten.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

void addSubpaths(Contents& contents, const Path& path)
{
    for (const Subpath& subpath : path.subpaths()) {
        ++contents.subpaths;
        contents.closedSubpaths += subpath.closed;
        contents.curves +=
            std::size_t(std::ranges::count_if(subpath.segments, &PathSegment::curved));
    }
}

} // namespace

void add(Contents& contents, const ObjectView& object, double tolerance)
{
    std::vector<clipping::Segment> lines;
    ++contents.objects;
    const auto line = object.singleLine();
    if (line) {
        ++contents.subpaths;
        lines.push_back(*line);
    } else {
        addSubpaths(contents, object.path());
        appendSegments(object.path(), tolerance, lines);
    }
    contents.lines += lines.size();
    for (const auto& [a, b] : lines) {
        contents.length += std::hypot(b.x - a.x, b.y - a.y);
        const clipping::Window box{glm::min(a, b), glm::max(a, b)};
        contents.bounds = contents.bounds
                              ? clipping::Window{glm::min(contents.bounds->min, box.min),
                                                 glm::max(contents.bounds->max, box.max)}
                              : box;
    }
}

Contents contentsOf(const Document& document)
{
    Contents contents;
    const double tolerance = usualTolerance(document.page());
    document.objects().forEach(
        0, document.objects().size(),
        [&](std::size_t, const ObjectView& object) { add(contents, object, tolerance); });
    return contents;
}

} // namespace app
