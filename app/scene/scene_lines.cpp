// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/scene_lines.h"

#include "app/document/flatten.h"
#include "app/scene/scene_block_cache.h"

#include <algorithm>
#include <atomic>
#include <cassert>

namespace app {

SceneLines::SceneLines(std::vector<Shared<SceneBlock>> blocks) : blocks_(std::move(blocks))
{
    static std::atomic<std::uint64_t> revisions{0};
    runs_.reserve(blocks_.size());
    std::size_t object = 0;
    for (const Shared<SceneBlock>& block : blocks_) {
        object -= block->continues;
        runs_.push_back({size_, object, block->segments});
        size_ += block->segments.size();
        object += block->objects();
    }
    if (!blocks_.empty())
        revision_ = ++revisions;
}

std::size_t SceneLines::runOf(std::size_t line) const
{
    assert(line < size_);
    const auto next = std::ranges::upper_bound(runs_, line, {}, &Run::firstLine);
    return std::size_t(next - runs_.begin()) - 1;
}

clipping::Segment SceneLines::operator[](std::size_t line) const
{
    const Run& run = runs_[runOf(line)];
    return run.segments[line - run.firstLine];
}

std::size_t SceneLines::objectOf(std::size_t line) const
{
    const std::size_t at = runOf(line);
    return runs_[at].firstObject + blocks_[at]->objectOf(line - runs_[at].firstLine);
}

std::size_t SceneLines::firstLineOf(std::size_t object) const
{
    if (runs_.empty())
        return 0;
    // Find the first run that contains the object.
    auto run = std::ranges::lower_bound(runs_, object, {}, &Run::firstObject);
    if (run == runs_.end() || run->firstObject > object
        || (run != runs_.begin() && blocks_[std::size_t(run - runs_.begin())]->continues))
        --run;
    const auto at = std::size_t(run - runs_.begin());
    return run->firstLine + blocks_[at]->firstOf(object - run->firstObject);
}

SceneLines linesOf(const Objects& objects, const ObjectRanges& hidden, double tolerance)
{
    SceneBlockCache cache;
    cache.update(objects, hidden, tolerance);
    return SceneLines(cache.blocks());
}

SceneLines linesOf(const Document& document)
{
    return linesOf(document.objects(), document.containers().hiddenRanges(),
                   usualTolerance(document.page()));
}

} // namespace app
