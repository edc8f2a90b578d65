// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/cut_fill.h"

#include "clipping/area/clip_area.h"

#include <glm/common.hpp>

#include <limits>

namespace app {
namespace {

ClipRegion shown(const ClipRegion& region, Painted part)
{
    if (part == Painted::Kept)
        return region;
    return withKeep(region, region.keep == Keep::Inside ? Keep::Outside : Keep::Inside);
}

// Open paths are filled as if closed.
clipping::Area areaOf(const Outline& outline, FillRule rule)
{
    clipping::Area area{{}, {}, clipping::FillRule(rule)};
    const clipping::Segment* last = nullptr;
    const auto finish = [&] {
        if (last)
            area.points.push_back(last->b);
        area.ringEnds.push_back(std::uint32_t(area.points.size()));
    };
    for (const auto& lines : outline)
        for (const clipping::Segment& line : lines) {
            if (last && last->b != line.a)
                finish();
            area.points.push_back(line.a);
            last = &line;
        }
    finish();
    return area;
}

std::vector<clipping::Segment> linesOf(const clipping::ClippedArea& area)
{
    std::vector<clipping::Segment> lines;
    std::size_t first = 0;
    for (const std::uint32_t end : area.ringEnds) {
        for (std::size_t i = first; i < end; ++i)
            lines.push_back({area.points[i], area.points[i + 1 < end ? i + 1 : first]});
        first = end;
    }
    return lines;
}

} // namespace

CutFill::CutFill(const ClipRegion* region, Painted part, const std::stop_token& stop) : stop_(stop)
{
    if (!region || region->everything() || part == Painted::All)
        return;
    region_ = shown(*region, part);
    windows_ = areaWindows(region_);
}

Remains CutFill::remains(const clipping::Window& box) const
{
    return cuts() ? remainsOf(region_, box) : Remains::Whole;
}

std::vector<clipping::Segment> CutFill::clip(const Outline& outline, FillRule rule) const
{
    const auto clipped = clipping::clipArea(areaOf(outline, rule), *windows_, stop_);
    std::vector<clipping::Segment> lines;
    if (clipped.part == clipping::AreaPart::Whole)
        for (const auto& part : outline)
            lines.insert(lines.end(), part.begin(), part.end());
    return clipped.part == clipping::AreaPart::Cut ? linesOf(clipped) : lines;
}

clipping::Window boxOf(const Outline& outline)
{
    constexpr double infinite = std::numeric_limits<double>::infinity();
    clipping::Window box{Point(infinite), Point(-infinite)};
    for (const auto& lines : outline)
        for (const auto& [a, b] : lines)
            box = {glm::min(box.min, glm::min(a, b)), glm::max(box.max, glm::max(a, b))};
    return box;
}

namespace {

// Clips the outline to the half plane sign * (p[axis] - bound) >= 0.
std::vector<Point> half(std::span<const Point> outline, int axis, double bound, double sign)
{
    std::vector<Point> kept;
    kept.reserve(outline.size() + 4);
    const auto depth = [&](const Point& p) { return sign * (p[axis] - bound); };
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point& from = outline[i == 0 ? outline.size() - 1 : i - 1];
        const Point& to = outline[i];
        if ((depth(from) < 0) != (depth(to) < 0)) {
            Point cut = from + (to - from) * (depth(from) / (depth(from) - depth(to)));
            cut[axis] = bound;
            kept.push_back(cut);
        }
        if (depth(to) >= 0)
            kept.push_back(to);
    }
    return kept;
}

} // namespace

std::vector<Point> areaInside(std::span<const Point> outline, const clipping::Window& window)
{
    std::vector<Point> kept = half(outline, 0, window.min.x, 1);
    kept = half(kept, 0, window.max.x, -1);
    kept = half(kept, 1, window.min.y, 1);
    return half(kept, 1, window.max.y, -1);
}

} // namespace app
