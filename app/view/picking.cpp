// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/picking.h"

#include "app/document/object_view.h"
#include "app/view/area_at.h"
#include "app/view/objects_in.h"

#include <algorithm>
#include <limits>
#include <ranges>
#include <unordered_map>

namespace app {

constexpr int mostHalvings = 10;           // of the radius, in a crowd
constexpr double underPoint = 1.0 / 32;    // of the radius: a fifth of a pixel for the pointer
constexpr std::size_t mostAtOnce = 10'000; // lines of a drawing whose grids are laid at once

std::vector<std::size_t> Picking::near(const Point& point, double radius) const
{
    std::vector<std::size_t> found;
    NearLimits none;
    find(point, radius, none, found);
    return found;
}

std::vector<std::size_t> Picking::near(const Point& point, double radius, NearLimits limits) const
{
    std::vector<std::size_t> found, before; // before: in the larger circle, which has too many
    for (int i = 0; i < mostHalvings && !find(point, radius, limits, found); ++i) {
        radius /= 2;
        before.swap(found);
    }
    if (limits.looks == 0 && found.size() < before.size())
        found.swap(before);
    found.resize(std::min(found.size(), limits.found));
    return found;
}

// False: it stopped because there are more lines.
bool Picking::find(const Point& point, double radius, NearLimits& limits,
                   std::vector<std::size_t>& found) const
{
    follow();
    found.clear();
    for (std::size_t i = 0; i < blocks_.size(); ++i)
        if (!findIn(i, point, radius, limits, found))
            return false;
    return true;
}

bool Picking::findIn(std::size_t at, const Point& point, double radius, NearLimits& limits,
                     std::vector<std::size_t>& found) const
{
    Block& block = blocks_[at];
    const double reach = radius * (1 + 1e-6);
    if (block.block->segments.empty() || isOutside(block.around, {point - reach, point + reach}))
        return true;
    if (!block.grid)
        grid(block);
    return block.grid->findNear(block.block->segments, point, radius,
                                scene_.lines().runs()[at].firstLine, found, limits);
}

void Picking::grid(Block& block) const
{
    const auto& segments = block.block->segments;
    block.isLaid = scene_.lines().size() <= mostAtOnce;
    block.grid = block.isLaid ? BlockGrid(segments) : BlockGrid::ofOneCell(segments.size());
    if (!block.isLaid && !laying_.active())
        layNext();
}

void Picking::layNext() const
{
    const auto next = std::ranges::find(blocks_, false, &Block::isLaid);
    if (next == blocks_.end())
        return;
    laying_.start([block = next->block](const Follower&) { return BlockGrid(block->segments); },
                  [this, block = next->block](BlockGrid laid) {
                      const auto of = std::ranges::find_if(blocks_, [&](const Block& each) {
                          return sameAddress(each.block, block);
                      });
                      if (of != blocks_.end()) {
                          of->grid = std::move(laid);
                          of->isLaid = true;
                      }
                      layNext();
                  });
}

std::optional<std::size_t> Picking::nearest(const Point& point, double radius) const
{
    follow();
    const SceneLines& lines = scene_.lines();
    const double under = radius * underPoint;
    std::optional<std::size_t> best;
    double least = radius;
    std::vector<std::size_t> found;
    for (std::size_t i = blocks_.size(); i-- > 0;) {
        found.clear();
        NearLimits none;
        findIn(i, point, least, none, found);
        for (const std::size_t line : found | std::views::reverse) {
            const double d = distance(point, lines[line]);
            if (!(best ? d < least : d <= least) || !pickable(lines.objectOf(line)))
                continue;
            if (d <= under)
                return line;
            least = d;
            best = line;
        }
    }
    return best;
}

std::optional<std::size_t> Picking::areaAt(const Point& point) const
{
    return app::areaAt(document_.now(), scene_.lines(), point);
}

// Objects with lines are shown, but may be locked.
ObjectRanges Picking::objectsIn(const clipping::Window& rectangle, Box box) const
{
    const ObjectRanges found = box == Box::Contains ? objectsWithin(scene_.lines(), rectangle)
                                                    : objectsTouching(scene_.lines(), rectangle);
    return without(found, document_.now().containers().lockedRanges());
}

// Updates the blocks. Most edits leave nearly all of them unchanged.
void Picking::follow() const
{
    const SceneLines& lines = scene_.lines();
    if (revision_ == lines.revision())
        return;
    revision_ = lines.revision();
    std::unordered_map<const SceneBlock*, Block*> known;
    for (Block& block : blocks_)
        known.emplace(&*block.block, &block);
    std::vector<Block> blocks;
    blocks.reserve(lines.blocks().size());
    for (const Shared<SceneBlock>& block : lines.blocks()) {
        const auto before = known.find(&*block);
        if (before != known.end()) {
            blocks.push_back(std::move(*before->second));
            known.erase(before);
            continue;
        }
        blocks.push_back({block});
        for (const FloatBox& box : block->boxes)
            blocks.back().around =
                &box == &block->boxes.front() ? box : united(blocks.back().around, box);
    }
    blocks_ = std::move(blocks);
}

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
