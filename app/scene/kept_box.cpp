// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/kept_box.h"

#include <glm/common.hpp>

#include <limits>

namespace app {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

bool hasPoints(const clipping::Window& box)
{
    return box.min.x <= box.max.x && box.min.y <= box.max.y;
}

clipping::Window boxAroundAll(const std::vector<Point>& points)
{
    clipping::Window box{Point(endless), Point(-endless)};
    for (const Point& point : points)
        box = {glm::min(box.min, point), glm::max(box.max, point)};
    return box;
}

} // namespace

std::optional<clipping::Window> keptBox(const ClipRegion& region)
{
    if (region.everything() || region.keep == Keep::Outside)
        return std::nullopt;
    clipping::Window box{Point(endless), Point(-endless)};
    if (region.startsFull())
        box = {Point(-endless), Point(endless)};
    for (const ClipRegion::Step& step : region.steps)
        if (step.operation == WindowOperation::Intersect)
            box = {glm::max(box.min, step.box.min), glm::min(box.max, step.box.max)};
        else if (step.operation == WindowOperation::Add && hasPoints(step.box))
            box = {glm::min(box.min, step.box.min), glm::max(box.max, step.box.max)};
    return box.min.x == -endless ? std::nullopt : std::optional(box);
}

SharedUnderlay keptOf(const SharedUnderlay& image, const ClipRegion& region)
{
    const auto box = keptBox(region);
    if (!box)
        return remainsOf(region, boxAroundAll(outlineOf(*image))) == Remains::Gone
                   ? SharedUnderlay()
                   : image;
    Underlay left = *image;
    if (!hasPoints(*box) || !cut(left, cornersOfBox(*box)))
        return {};
    return left == *image ? image : SharedUnderlay(std::move(left));
}

bool isCutExactly(const Underlay& image, const ClipRegion& region)
{
    if (region.everything() || (region.single() && region.keep == Keep::Inside))
        return true;
    return remainsOf(region, boxAroundAll(outlineOf(image))) != Remains::Pieces;
}

} // namespace app
