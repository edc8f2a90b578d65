// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/objects_in.h"

#include "clipping/algorithm.h"

#include <glm/common.hpp>

#include <algorithm>

namespace app {
namespace {

using clipping::Segment;
using clipping::Window;
using Lines = std::span<const Segment>;

/// The rule that all lines of an object must lie in the rectangle.
class Within {
public:
    explicit Within(const Window& rectangle) : rectangle_(rectangle) {}

    bool holds(Lines lines) const { return std::ranges::all_of(lines, *this); }
    static bool together(bool a, bool b) { return a && b; }
    bool operator()(const Segment& s) const
    {
        const Point min = glm::min(s.a, s.b), max = glm::max(s.a, s.b);
        return min.x >= rectangle_.min.x && min.y >= rectangle_.min.y && max.x <= rectangle_.max.x
               && max.y <= rectangle_.max.y;
    }

private:
    Window rectangle_;
};

/// The rule that at least one line of an object must have a point in the rectangle.
class Touching {
public:
    explicit Touching(const Window& rectangle) : rectangle_(rectangle) {}

    bool holds(Lines lines) const { return std::ranges::any_of(lines, *this); }
    static bool together(bool a, bool b) { return a || b; }
    bool operator()(const Segment& s) const
    {
        static const auto clip = clipping::exactAlgorithm().corrected.clip;
        return clip(s, rectangle_).has_value();
    }

private:
    Window rectangle_;
};

template <class Rule>
class RectangleSearch {
public:
    RectangleSearch(const SceneLines& lines, const Window& rectangle)
        : lines_(lines), rectangle_(rectangle), rule_(rectangle)
    {
    }

    ObjectRanges objects()
    {
        for (at_ = 0; at_ < lines_.blocks().size(); ++at_)
            searchBlock(*lines_.blocks()[at_]);
        return std::move(found_);
    }

private:
    void searchBlock(const SceneBlock& block)
    {
        const auto isFar = [&](const FloatBox& box) { return isOutside(box, rectangle_); };
        if (!block.continues && std::ranges::all_of(block.boxes, isFar))
            return;
        std::size_t chunk = 0;
        ObjectRange range; // not yet added to found_
        for (std::size_t i = 0; i < block.objects(); ++i) {
            const std::size_t first = block.firstOf(i), end = block.firstOf(i + 1);
            if (first == end)
                continue;
            while (block.endOfChunk(chunk) <= first)
                ++chunk;
            const std::size_t number = lines_.runs()[at_].firstObject + i;
            bool in = holds(block, chunk, first, end);
            if (i == 0 && block.continues)
                in = Rule::together(found_.contains(number), in);
            if (i == 0 && block.continues && !in)
                found_.erase(number);
            if (!in)
                continue;
            if (range.end != number) {
                found_.insert(range);
                range.first = number;
            }
            range.end = number + 1;
        }
        found_.insert(range);
    }

    // Whether the rule holds for the lines [first, end) of a block; the first of them lies in the
    // chunk. A box that is inside or outside decides for all its lines.
    bool holds(const SceneBlock& block, std::size_t chunk, std::size_t first, std::size_t end)
    {
        bool holds = here(block, chunk, first, end);
        while (block.endOfChunk(chunk) < end) {
            first = block.endOfChunk(chunk++);
            holds = Rule::together(holds, here(block, chunk, first, end));
        }
        return holds;
    }

    bool here(const SceneBlock& block, std::size_t chunk, std::size_t first, std::size_t end)
    {
        const FloatBox& box = block.chunks[chunk].box;
        if (isOutside(box, rectangle_))
            return false;
        if (isInside(box, rectangle_))
            return true;
        const std::size_t last = std::min(end, block.endOfChunk(chunk));
        return rule_.holds(Lines(block.segments).subspan(first, last - first));
    }

    const SceneLines& lines_;
    Window rectangle_;
    Rule rule_;
    std::size_t at_ = 0; // the current block
    ObjectRanges found_;
};

} // namespace

ObjectRanges objectsWithin(const SceneLines& lines, const Window& rectangle)
{
    return RectangleSearch<Within>(lines, rectangle).objects();
}

ObjectRanges objectsTouching(const SceneLines& lines, const Window& rectangle)
{
    return RectangleSearch<Touching>(lines, rectangle).objects();
}

} // namespace app
