// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/scene_block.h"

#include "app/scene/scene_chunks.h"

#include <algorithm>
#include <cassert>

namespace app {
namespace {

/// All segments of an object block, and the first segment of each object.
struct Flattened {
    std::vector<clipping::Segment> segments;
    std::vector<std::size_t> first; // one for each object, then the number of segments
};

Flattened flattened(const ObjectBlock& objects, std::span<const ObjectRange> hidden,
                    double tolerance)
{
    Flattened all;
    all.segments.reserve(objects.points);
    all.first.reserve(objects.size() + 1);
    for (std::size_t i = 0; i < objects.size(); ++i) {
        all.first.push_back(all.segments.size());
        while (!hidden.empty() && hidden.front().end <= i)
            hidden = hidden.subspan(1);
        const bool isShown = !objects.isHidden(i) && (hidden.empty() || i < hidden.front().first);
        if (isShown && objects.paths.empty())
            all.segments.push_back(objects.lines[i]);
        else if (isShown)
            appendSegments(objects.paths[i], tolerance, all.segments);
    }
    all.first.push_back(all.segments.size());
    return all;
}

/// Divides the segments of an object block into scene blocks.
class Division {
public:
    Division(const ObjectBlock& objects, const Flattened& all) : objects_(objects), all_(all) {}

    std::vector<Shared<SceneBlock>> blocks() const
    {
        std::vector<Shared<SceneBlock>> blocks;
        std::size_t begin = 0;
        do {
            const std::size_t end =
                std::min(begin + SceneBlock::mostSegments, all_.segments.size());
            blocks.emplace_back(block(begin, end));
            begin = end;
        } while (begin < all_.segments.size());
        return blocks;
    }

private:
    SceneBlock block(std::size_t begin, std::size_t end) const
    {
        const std::size_t first = begin == 0 ? 0 : objectOf(begin);
        std::size_t last = objects_.size();
        if (end < all_.segments.size()) {
            last = objectOf(end);
            last += all_.first[last] < end; // it begins here and continues in the next block
        }
        SceneBlock block;
        block.continues = all_.first[first] < begin;
        const auto segments = std::span(all_.segments).subspan(begin, end - begin);
        block.segments.assign(segments.begin(), segments.end());
        if (!haveOneEach(first, last, begin, end))
            for (std::size_t i = first; i <= last; ++i)
                block.firstOfObject.push_back(
                    std::uint32_t(std::clamp(all_.first[i], begin, end) - begin));
        block.firstOfObject.shrink_to_fit();
        const std::span styles(objects_.styles);
        makeChunks(block, styles.size() == 1 ? styles : styles.subspan(first, last - first));
        return block;
    }

    // The object that the segment belongs to.
    std::size_t objectOf(std::size_t segment) const
    {
        return std::size_t(std::ranges::upper_bound(all_.first, segment) - all_.first.begin()) - 1;
    }

    bool haveOneEach(std::size_t first, std::size_t last, std::size_t begin, std::size_t end) const
    {
        for (std::size_t i = first; i < last; ++i)
            if (all_.first[i] != begin + (i - first))
                return false;
        return last - first == end - begin;
    }

    const ObjectBlock& objects_;
    const Flattened& all_;
};

} // namespace

std::size_t SceneBlock::objects() const
{
    return firstOfObject.empty() ? segments.size() : firstOfObject.size() - 1;
}

std::size_t SceneBlock::firstOf(std::size_t object) const
{
    assert(object <= objects());
    return firstOfObject.empty() ? object : firstOfObject[object];
}

std::size_t SceneBlock::objectOf(std::size_t segment) const
{
    assert(segment < segments.size());
    if (firstOfObject.empty())
        return segment;
    return std::size_t(std::ranges::upper_bound(firstOfObject, segment) - firstOfObject.begin())
           - 1;
}

std::size_t SceneBlock::chunkOf(std::size_t segment) const
{
    assert(segment < segments.size());
    const auto next = std::ranges::upper_bound(chunks, segment, {}, &SceneChunk::first);
    return std::size_t(next - chunks.begin()) - 1;
}

std::size_t SceneBlock::endOfChunk(std::size_t chunk) const
{
    return chunk + 1 < chunks.size() ? chunks[chunk + 1].first : segments.size();
}

std::vector<Shared<SceneBlock>> sceneBlocksOf(const ObjectBlock& objects,
                                              std::span<const ObjectRange> hidden, double tolerance)
{
    return Division(objects, flattened(objects, hidden, tolerance)).blocks();
}

} // namespace app
