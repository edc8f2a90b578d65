// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/colour_at.h"

#include "app/document/line_colour.h"

namespace app {
namespace {

constexpr NearLimits few{600, 20'000};

} // namespace

std::optional<Colour> colourAt(const Document& document, const Scene& scene, const Picking& picking,
                               const Point& point, double radius)
{
    const Objects& objects = document.objects();
    auto line = picking.nearest(point, radius);
    if (const auto all = picking.near(point, radius, few); !line && !all.empty())
        line = all.back(); // the topmost one
    if (line)
        return lineColour(objects[scene.lines().objectOf(*line)]);
    if (const auto area = picking.areaAt(point))
        return objects[*area].style().fill;
    return std::nullopt;
}

} // namespace app
