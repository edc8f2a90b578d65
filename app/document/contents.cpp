// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/contents.h"

#include "app/document/flatten.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

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

namespace {

class Around {
public:
    void add(const Point& p, double margin)
    {
        min_ = glm::min(min_, p - margin);
        max_ = glm::max(max_, p + margin);
    }

    Page page() const
    {
        Page page;
        if (max_.x > min_.x && max_.y > min_.y) {
            page.min = min_;
            page.size = max_ - min_;
            page.width = page.height = {100, Unit::Percent};
        }
        return page;
    }

private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    Point min_{infinity, infinity}, max_{-infinity, -infinity};
};

double marginOf(const Style& style) { return style.stroke ? style.width / 2 : 0; }

} // namespace

Page pageAround(const Objects& objects)
{
    Around around;
    objects.forEach(0, objects.size(), [&](std::size_t, const ObjectView& object) {
        const double margin = marginOf(object.style());
        if (const auto line = object.singleLine()) {
            around.add(line->a, margin);
            around.add(line->b, margin);
        } else {
            object.path().forEachPoint([&](const Point& point) { around.add(point, margin); });
        }
    });
    return around.page();
}

} // namespace app
