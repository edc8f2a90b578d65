// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/snapping/centre_index.h"

#include "app/view/snapping/places.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <unordered_map>

namespace app {
namespace {

constexpr std::size_t mostFound = 1000;

struct CentreOf {
    using Result = std::optional<Point>;
    Result operator()(const RectangleRecipe& recipe) const
    {
        return recipe.corner + recipe.size * 0.5;
    }
    Result operator()(const EllipseRecipe& recipe) const { return recipe.centre; }
    Result operator()(const StarRecipe& recipe) const { return recipe.centre; }
    template <class Other>
    Result operator()(const Other&) const
    {
        return std::nullopt;
    }
};

// Calls visit(Point) for the centre of each circular arc.
template <class Visit>
void forEachArc(const Path& path, const Visit& visit)
{
    for (const Subpath& subpath : path.subpaths()) {
        Point from = subpath.start;
        for (const PathSegment& segment : subpath.segments) {
            if (segment.curved)
                if (const auto centre =
                        arcCentre({from, segment.control1, segment.control2, segment.to}))
                    visit(*centre);
            from = segment.to;
        }
    }
}

} // namespace

std::vector<Point> CentreIndex::near(const Point& point, double radius,
                                     const ObjectRanges& without) const
{
    follow();
    std::vector<Point> found;
    const Objects& objects = document_.now().objects();
    const SceneLines& lines = scene_.lines();
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        const auto& centres = blocks_[i].centres;
        auto centre = std::ranges::lower_bound(centres, point.x - radius, {},
                                               [](const Centre& c) { return c.at.x; });
        for (; centre != centres.end() && centre->at.x <= point.x + radius; ++centre) {
            if (glm::distance(centre->at, point) > radius)
                continue;
            const std::size_t object = objects.firstOf(i) + centre->object;
            const bool shown = lines.firstLineOf(object) < lines.firstLineOf(object + 1);
            if (!shown || without.contains(object))
                continue;
            found.push_back(centre->at);
            if (found.size() == mostFound)
                return found;
        }
    }
    return found;
}

void CentreIndex::follow() const
{
    const auto now = document_.now().objects().blocks();
    const auto same = [](const Block& known, const Shared<ObjectBlock>& block) {
        return &*known.block == &*block;
    };
    if (std::ranges::equal(blocks_, now, same))
        return;
    std::unordered_map<const ObjectBlock*, Block*> known;
    for (Block& block : blocks_)
        known.emplace(&*block.block, &block);
    std::vector<Block> blocks;
    blocks.reserve(now.size());
    for (const Shared<ObjectBlock>& block : now) {
        const auto before = known.find(&*block);
        blocks.push_back(before == known.end() ? Block{block, centresOf(*block)} : *before->second);
    }
    blocks_ = std::move(blocks);
}

std::vector<CentreIndex::Centre> CentreIndex::centresOf(const ObjectBlock& block)
{
    std::vector<Centre> centres;
    if (block.paths.empty())
        return centres; // single lines
    for (std::size_t i = 0; i < block.size(); ++i) {
        const auto add = [&](const Point& at) { centres.push_back({at, std::uint32_t(i)}); };
        const auto own = std::visit(CentreOf(), block.particularsOf(i)->recipe);
        if (own)
            add(*own);
        else if (!block.paths[i].straight())
            forEachArc(block.paths[i], add);
    }
    std::ranges::sort(centres, {}, [](const Centre& centre) { return centre.at.x; });
    return centres;
}

} // namespace app
