// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/objects_in.h"

#include "app/base/background.h"
#include "app/base/in_parallel.h"
#include "clipping/algorithm.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace app {
namespace {

using clipping::Segment;
using clipping::Window;
using Lines = std::span<const Segment>;

using Marks = std::span<bool>; ///< one for each line

/// The rule that all lines of an object must lie in the rectangle.
struct Within {
    static bool together(bool a, bool b) { return a && b; }
    static bool holds(Marks marks) { return std::ranges::all_of(marks, std::identity()); }
    static void mark(Lines lines, const Window& rectangle, Marks marks)
    {
        std::ranges::transform(lines, marks.begin(), [&](const Segment& s) {
            const Point min = glm::min(s.a, s.b), max = glm::max(s.a, s.b);
            return min.x >= rectangle.min.x && min.y >= rectangle.min.y && max.x <= rectangle.max.x
                   && max.y <= rectangle.max.y;
        });
    }
};

/// The rule that at least one line of an object must have a point in the rectangle.
struct Touching {
    static bool together(bool a, bool b) { return a || b; }
    static bool holds(Marks marks) { return std::ranges::any_of(marks, std::identity()); }
    static void mark(Lines lines, const Window& rectangle, Marks marks)
    {
        static const auto clipAll = clipping::exactAlgorithm().corrected.clipAll;
        std::array<clipping::Clipped, SceneBlock::mostInChunk> pieces;
        std::ranges::fill(marks, false);
        const std::size_t count = clipAll(lines, rectangle, pieces);
        for (const clipping::Clipped& piece : std::span(pieces).first(count))
            marks[piece.source] = true;
    }
};

/// Searches one block.
template <class Rule>
class BlockSearch {
public:
    BlockSearch(const SceneBlock& block, const Window& rectangle)
        : block_(block), rectangle_(rectangle)
    {
    }

    /// The objects for which the rule holds, numbered within the block.
    std::vector<ObjectRange> objects()
    {
        std::vector<ObjectRange> found;
        const auto isFar = [&](const FloatBox& box) { return isOutside(box, rectangle_); };
        if (std::ranges::all_of(block_.boxes, isFar))
            return found;
        std::size_t chunk = 0;
        for (std::size_t i = 0; i < block_.objects(); ++i) {
            const std::size_t first = block_.firstOf(i), end = block_.firstOf(i + 1);
            if (first == end)
                continue;
            while (block_.endOfChunk(chunk) <= first)
                ++chunk;
            if (!holds(chunk, first, end))
                continue;
            if (found.empty() || found.back().end != i)
                found.push_back({i, i});
            found.back().end = i + 1;
        }
        return found;
    }

private:
    // Whether the rule holds for the lines [first, end); the first of them lies in the chunk.
    bool holds(std::size_t chunk, std::size_t first, std::size_t end)
    {
        bool holds = here(chunk, first, end);
        while (block_.endOfChunk(chunk) < end) {
            first = block_.endOfChunk(chunk++);
            holds = Rule::together(holds, here(chunk, first, end));
        }
        return holds;
    }

    // A box that is inside or outside decides for all its lines.
    bool here(std::size_t chunk, std::size_t first, std::size_t end)
    {
        const FloatBox& box = block_.chunks[chunk].box;
        if (isOutside(box, rectangle_))
            return false;
        if (isInside(box, rectangle_))
            return true;
        const std::size_t begin = block_.chunks[chunk].first, past = block_.endOfChunk(chunk);
        if (std::exchange(marked_, chunk) != chunk)
            Rule::mark(Lines(block_.segments).subspan(begin, past - begin), rectangle_,
                       Marks(marks_).first(past - begin));
        return Rule::holds(Marks(marks_).subspan(first - begin, std::min(end, past) - first));
    }

    const SceneBlock& block_;
    const Window& rectangle_;
    std::size_t marked_ = std::size_t(-1); // the chunk that marks_ belongs to
    std::array<bool, SceneBlock::mostInChunk> marks_{};
};

template <class Rule>
ObjectRanges objectsFor(const SceneLines& lines, const Window& rectangle)
{
    const auto blocks = lines.blocks();
    std::vector<std::vector<ObjectRange>> found(blocks.size());
    inParallel(paintingThreads(), workersOf(paintingThreads()), blocks.size(),
               [&](std::size_t i, std::size_t) {
                   found[i] = BlockSearch<Rule>(*blocks[i], rectangle).objects();
               });
    ObjectRanges all;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const std::size_t before = lines.runs()[i].firstObject;
        if (blocks[i]->continues && blocks[i]->firstOf(1) > 0) { // the object has lines in both
            const bool in = !found[i].empty() && found[i].front().first == 0;
            if (!Rule::together(all.contains(before), in)) {
                all.erase(before);
                if (in && ++found[i].front().first == found[i].front().end)
                    found[i].erase(found[i].begin());
            }
        }
        for (const auto& [first, end] : found[i])
            all.insert({before + first, before + end});
    }
    return all;
}

} // namespace

ObjectRanges objectsWithin(const SceneLines& lines, const Window& rectangle)
{
    return objectsFor<Within>(lines, rectangle);
}

ObjectRanges objectsTouching(const SceneLines& lines, const Window& rectangle)
{
    return objectsFor<Touching>(lines, rectangle);
}

} // namespace app
