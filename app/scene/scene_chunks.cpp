// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/scene_chunks.h"

#include <algorithm>

namespace app {
namespace {

// The end of the stroke that begins at `begin`, or the point at which it fills a chunk.
std::size_t endOfStroke(std::span<const clipping::Segment> segments, std::size_t begin)
{
    const std::size_t last = std::min(begin + SceneBlock::mostInChunk, segments.size());
    for (std::size_t i = begin + SceneBlock::fewInChunk; i < last; ++i)
        if (segments[i].a != segments[i - 1].b)
            return i;
    return last;
}

double areaOf(const FloatBox& box)
{
    return (double(box.maxX) - double(box.minX)) * (double(box.maxY) - double(box.minY));
}

// Whether the box around both has clearly less area than the two boxes together.
bool boxCovers(const FloatBox& a, const FloatBox& b)
{
    return areaOf(united(a, b)) < 0.75 * (areaOf(a) + areaOf(b));
}

void addChunks(SceneBlock& block, std::size_t begin, std::size_t end, StyleIndex style)
{
    const std::span segments = std::span(block.segments).first(end);
    const std::size_t before = block.chunks.size();
    while (begin < end) {
        const std::size_t next = endOfStroke(segments, begin);
        const FloatBox box = boxAround(segments.subspan(begin, next - begin));
        SceneChunk* last = block.chunks.size() > before ? &block.chunks.back() : nullptr;
        if (last && next - last->first <= SceneBlock::mostInChunk && boxCovers(last->box, box))
            last->box = united(last->box, box);
        else
            block.chunks.push_back({box, style, std::uint32_t(begin)});
        begin = next;
    }
}

// The end of the run of objects from `i` on that have its style or no segments.
std::size_t endOfStyle(const SceneBlock& block, std::span<const StyleIndex> styles, std::size_t i)
{
    if (styles.size() == 1)
        return block.objects();
    const StyleIndex style = styles[i];
    while (++i < styles.size())
        if (styles[i] != style && block.firstOf(i) < block.firstOf(i + 1))
            break;
    return i;
}

} // namespace

void makeChunks(SceneBlock& block, std::span<const StyleIndex> styles)
{
    for (std::size_t i = 0, end = 0; i < block.objects(); i = end) {
        end = endOfStyle(block, styles, i);
        addChunks(block, block.firstOf(i), block.firstOf(end), styles[styles.size() == 1 ? 0 : i]);
    }
    block.chunks.shrink_to_fit();
    block.boxes.reserve((block.chunks.size() + SceneBlock::chunksInBox - 1)
                        / SceneBlock::chunksInBox);
    for (std::size_t i = 0; i < block.chunks.size(); ++i) {
        const FloatBox& box = block.chunks[i].box;
        if (i % SceneBlock::chunksInBox == 0)
            block.boxes.push_back(box);
        else
            block.boxes.back() = united(block.boxes.back(), box);
    }
}

} // namespace app
