// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/scene_block_cache.h"

#include "app/base/background.h"
#include "app/base/in_parallel.h"

#include <algorithm>
#include <iterator>
#include <unordered_map>

namespace app {
namespace {

/// Gives the hidden objects of each block in turn.
class HiddenInBlocks {
public:
    explicit HiddenInBlocks(const ObjectRanges& hidden) : left_(hidden.ranges()) {}

    /// The hidden objects of the block [first, end), numbered within it.
    std::vector<ObjectRange> next(std::size_t first, std::size_t end)
    {
        while (!left_.empty() && left_.front().end <= first)
            left_ = left_.subspan(1);
        std::vector<ObjectRange> hidden;
        for (const ObjectRange& range : left_) {
            if (range.first >= end)
                break;
            hidden.push_back(
                {std::max(range.first, first) - first, std::min(range.end, end) - first});
        }
        return hidden;
    }

private:
    std::span<const ObjectRange> left_;
};

} // namespace

// Makes one source for each block, reusing the old ones. Most blocks are unchanged, at both ends of
// the list. A source without scene blocks is new.
void SceneBlockCache::take(std::span<const Shared<ObjectBlock>> blocks)
{
    const auto isSame = [](const Source& source, const Shared<ObjectBlock>& block) {
        return sameAddress(source.objects, block);
    };
    const auto front = std::ranges::mismatch(sources_, blocks, isSame);
    std::span old(front.in1, sources_.end());
    std::span blocksLeft(front.in2, blocks.end());
    std::size_t back = 0;
    while (back < std::min(old.size(), blocksLeft.size())
           && isSame(old[old.size() - 1 - back], blocksLeft[blocksLeft.size() - 1 - back]))
        ++back;
    old = old.first(old.size() - back);
    std::unordered_map<const ObjectBlock*, const Source*> known;
    for (const Source& source : old)
        known.emplace(&*source.objects, &source);

    std::vector<Source> sources;
    sources.reserve(blocks.size());
    sources.assign(std::move_iterator(sources_.begin()), std::move_iterator(front.in1));
    for (const Shared<ObjectBlock>& block : blocksLeft.first(blocksLeft.size() - back)) {
        const auto found = known.find(&*block);
        sources.push_back(found != known.end() ? *found->second : Source{block, {}, {}});
    }
    sources.insert(sources.end(), std::move_iterator(sources_.end() - std::ptrdiff_t(back)),
                   std::move_iterator(sources_.end()));
    sources_ = std::move(sources);
}

bool SceneBlockCache::update(const Objects& objects, const ObjectRanges& hidden, double tolerance)
{
    const auto isSame = [](const Source& source, const Shared<ObjectBlock>& block) {
        return sameAddress(source.objects, block);
    };
    bool changed = false;
    if (!std::ranges::equal(sources_, objects.blocks(), isSame)) {
        take(objects.blocks());
        changed = true;
    }
    std::vector<Source*> outdated;
    HiddenInBlocks hiddenInBlocks(hidden);
    for (std::size_t i = 0; i < sources_.size(); ++i) {
        Source& source = sources_[i];
        const std::size_t first = objects.firstOf(i);
        auto hiddenHere = hiddenInBlocks.next(first, first + source.objects->size());
        if (!source.blocks.empty() && source.hidden == hiddenHere && tolerance == tolerance_)
            continue;
        source.hidden = std::move(hiddenHere);
        source.blocks.clear(); // the old ones are not theirs, also if memory ends meanwhile
        outdated.push_back(&source);
    }
    inParallel(paintingThreads(), workersOf(paintingThreads()), outdated.size(),
               [&](std::size_t i, std::size_t) {
                   Source& source = *outdated[i];
                   source.blocks = sceneBlocksOf(*source.objects, source.hidden, tolerance);
               });
    changed = changed || !outdated.empty();
    tolerance_ = tolerance;
    return changed;
}

std::vector<Shared<SceneBlock>> SceneBlockCache::blocks() const
{
    std::vector<Shared<SceneBlock>> all;
    all.reserve(sources_.size());
    for (const Source& source : sources_)
        all.insert(all.end(), source.blocks.begin(), source.blocks.end());
    return all;
}

} // namespace app
