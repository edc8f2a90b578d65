// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/window_borders.h"

#include "app/view/draw_list_builder.h"

#include <glm/geometric.hpp>

namespace app {
namespace {

// Painted in some milliseconds where the window fills the view.
constexpr std::size_t manyEdges = 5000;
constexpr double manyTimes = 20; // as long as its box is wide and high

std::vector<clipping::Segment> edgesOf(std::span<const Point> ring)
{
    std::vector<clipping::Segment> edges;
    edges.reserve(ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i)
        edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
    return edges;
}

} // namespace

bool isLong(const ClipRegion::Step& step)
{
    std::size_t count = 0;
    double length = 0;
    for (const auto& ring : step.rings) {
        count += ring.size();
        if (count > manyEdges)
            return true; // without measuring them: this is asked in every frame
        for (std::size_t i = 0; i < ring.size(); ++i)
            length += glm::distance(ring[i], ring[(i + 1) % ring.size()]);
    }
    const Point size = step.box.max - step.box.min;
    return length > manyTimes * (size.x + size.y);
}

DrawList windowBorders(const PictureOptions& options)
{
    PictureOptions asGiven = options; // the colours are chosen for the page
    asGiven.page.reset();
    asGiven.strokes = 1;
    DrawListBuilder builder(asGiven, 0);
    const auto paint = [&](const BorderLine& border, const Colour& colour, double width,
                           const std::vector<double>& dashes) {
        Style style{.stroke = colour, .width = width / options.view.zoom};
        for (const double dash : dashes)
            style.dashes.push_back(dash / options.view.zoom);
        for (const auto& ring : options.region->steps[border.step].rings)
            if (const auto edges = edgesOf(ring); !edges.empty() && !options.stop.stop_requested())
                builder.add(style, edges, 0, untouched(edges));
    };
    for (const BorderLine& border : options.borders) {
        if (border.widthBelow > 0)
            paint(border, border.below, border.widthBelow, {});
        paint(border, border.colour, border.width, border.dashes);
    }
    return builder.take();
}

} // namespace app
