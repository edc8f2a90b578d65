// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/page_around.h"

#include <glm/common.hpp>

#include <limits>

namespace app {
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
