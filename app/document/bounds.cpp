// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/bounds.h"

#include <glm/common.hpp>

namespace app {

std::optional<clipping::Window> boundsOf(const Scene& scene, const ObjectRanges& objects)
{
    std::optional<clipping::Window> all;
    for (const ObjectRange& range : objects.ranges()) {
        const auto first = scene.firstSegmentOf(range.first), end = scene.firstSegmentOf(range.end);
        for (const auto& s : scene.segments().subspan(first, end - first)) {
            const Point min = glm::min(s.a, s.b), max = glm::max(s.a, s.b);
            all = all ? clipping::Window{glm::min(all->min, min), glm::max(all->max, max)}
                      : clipping::Window{min, max};
        }
    }
    return all;
}

} // namespace app
