// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/scene_clipping.h"

#include "app/base/background.h"
#include "app/base/in_parallel.h"
#include "app/base/vector_registers.h"

namespace app {

SceneFrame SceneClipping::clip(const SceneLines& lines, const ClipRegion& region, ClipAll clipAll,
                               const std::stop_token& stop)
{
    makeBlocks(lines);
    workers_.resize(workersOf(paintingThreads()));
    workers_.front().start(region, clipAll, stop);
    for (auto other = workers_.begin() + 1; other != workers_.end(); ++other)
        other->startAs(workers_.front());
    const auto clip = [&](std::size_t block, std::size_t worker) {
        if (stop.stop_requested())
            return;
        emptyUpperHalves(); // Qt may have painted a picture before
        workers_[worker].clip(blocks_[block], remainsOf(block));
    };
    inParallel(paintingThreads(), workers_.size(), blocks_.size(), clip);
    SceneFrame frame{blocks_, lines.size()};
    for (const BlockClipping& worker : workers_) {
        frame.visible += worker.visible();
        frame.nanoseconds += worker.nanoseconds();
    }
    return frame;
}

void SceneClipping::makeBlocks(const SceneLines& lines)
{
    std::size_t chunks = 0;
    for (const auto& block : lines.blocks())
        chunks += block->chunks.size();
    remains_.resize(chunks);
    blocks_.clear();
    firstChunks_.clear();
    std::span<const Remains> left = remains_;
    for (std::size_t i = 0; i < lines.blocks().size(); ++i) {
        const SceneBlock& block = *lines.blocks()[i];
        const auto& [firstLine, firstObject, segments] = lines.runs()[i];
        firstChunks_.push_back(remains_.size() - left.size());
        blocks_.push_back({&block, firstObject, firstLine, left.first(block.chunks.size()), {}});
        left = left.subspan(block.chunks.size());
    }
}

std::span<Remains> SceneClipping::remainsOf(std::size_t block)
{
    return std::span(remains_).subspan(firstChunks_[block], blocks_[block].remains.size());
}

} // namespace app
