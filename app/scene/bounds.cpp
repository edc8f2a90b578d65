// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/bounds.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

using clipping::Segment;
using clipping::Window;

/// The lines of some objects.
struct LineRange {
    std::size_t first, end;
};

// Calls visit(box, segments) for each part of the lines; a part of a chunk has no box. If
// `looksInto(box)` is true for the box around several chunks, these chunks are visited one by one.
template <class LooksInto, class Visit>
void forEachBox(const SceneBlock& block, std::size_t first, std::size_t end,
                const LooksInto& looksInto, const Visit& visit)
{
    constexpr std::size_t many = SceneBlock::chunksInBox;
    const std::span segments(block.segments);
    std::size_t chunk = block.chunkOf(first);
    while (first < end) {
        const std::size_t last = block.endOfChunk(chunk);
        const std::size_t next = std::min(chunk + many, block.chunks.size());
        const bool begins = first == block.chunks[chunk].first;
        if (begins && chunk % many == 0 && block.endOfChunk(next - 1) <= end
            && !looksInto(block.boxes[chunk / many])) {
            visit(&block.boxes[chunk / many], segments.first(0));
            first = block.endOfChunk(next - 1);
            chunk = next;
            continue;
        }
        const auto lines = segments.subspan(first, std::min(last, end) - first);
        visit(begins && last <= end ? &block.chunks[chunk].box : nullptr, lines);
        first = last;
        ++chunk;
    }
}

bool isNumber(const FloatBox& box) { return !std::isnan(box.minX); }
bool hasNumbers(const Segment& s)
{
    return !std::isnan(s.a.x) && !std::isnan(s.a.y) && !std::isnan(s.b.x) && !std::isnan(s.b.y);
}

// Whether lines in `box` may reach as far as `all`, the box around everything.
bool reaches(const FloatBox& box, const FloatBox& all)
{
    return !isNumber(box) || box.minX == all.minX || box.minY == all.minY || box.maxX == all.maxX
           || box.maxY == all.maxY;
}

void extendOver(std::optional<Window>& all, std::span<const Segment> lines)
{
    for (const Segment& s : lines) {
        const Point min = glm::min(s.a, s.b), max = glm::max(s.a, s.b);
        all = all ? Window{glm::min(all->min, min), glm::max(all->max, max)} : Window{min, max};
    }
}

std::optional<Window> boundsOf(const SceneLines& lines, std::span<const LineRange> ranges)
{
    const auto forEach = [&](const auto& looksInto, const auto& visit) {
        for (const LineRange& range : ranges)
            lines.forEachPart(range.first, range.end, [&](auto run, auto first, auto end) {
                forEachBox(*lines.blocks()[run], first, end, looksInto, visit);
            });
    };
    std::optional<FloatBox> around; // of all boxes
    bool areNumbers = true;         // the lines without one
    forEach([](const FloatBox&) { return false; },
            [&](const FloatBox* box, const auto& some) {
                if (box)
                    around = around ? united(*around, *box) : *box;
                else
                    areNumbers = areNumbers && std::ranges::all_of(some, hasNumbers);
            });
    std::optional<Window> all;
    if (!areNumbers || (around && !isNumber(*around))) { // what is the least depends on the order
        for (const LineRange& range : ranges)
            lines.forEachPart(range.first, range.end, [&](auto run, auto first, auto end) {
                extendOver(all, lines.runs()[run].segments.subspan(first, end - first));
            });
    } else {
        forEach([&](const FloatBox& box) { return reaches(box, *around); },
                [&](const FloatBox* box, const auto& some) {
                    if (!box || reaches(*box, *around))
                        extendOver(all, some);
                });
    }
    return all;
}

} // namespace

std::optional<Window> boundsOf(const SceneLines& lines, const ObjectRanges& objects)
{
    std::vector<LineRange> ranges;
    for (const auto& [first, end] : objects.ranges())
        ranges.push_back({lines.firstLineOf(first), lines.firstLineOf(end)});
    return boundsOf(lines, ranges);
}

std::optional<Window> boundsOf(const SceneLines& lines)
{
    const LineRange all{0, lines.size()};
    return boundsOf(lines, std::span(&all, 1));
}

} // namespace app
