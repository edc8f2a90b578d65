// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/document/objects.h"
#include "app/scene/scene_block.h"

#include <algorithm>

namespace app {

/// All visible segments at one moment, numbered in painting order. A copy shares them, costs
/// O(blocks), and can be read by any thread.
class SceneLines {
public:
    /// The segments of one block.
    struct Run {
        std::size_t firstLine, firstObject;
        std::span<const clipping::Segment> segments; ///< may be empty
    };

    SceneLines() = default;
    explicit SceneLines(std::vector<Shared<SceneBlock>> blocks); ///< for all objects, in order

    std::size_t size() const { return size_; }
    clipping::Segment operator[](std::size_t line) const;
    std::span<const Run> runs() const { return runs_; }
    std::span<const Shared<SceneBlock>> blocks() const { return blocks_; } ///< one for each run

    std::size_t runOf(std::size_t line) const; ///< the run that contains the line

    /// The object that the line belongs to.
    std::size_t objectOf(std::size_t line) const;
    /// The first line of an object; object + 1 gives the end of its lines.
    std::size_t firstLineOf(std::size_t object) const;

    /// Calls visit(run, first, end) for each run that contains some of the lines [first, end), in
    /// order. The arguments first and end of visit are numbered within the run.
    template <class Visit>
    void forEachPart(std::size_t first, std::size_t end, const Visit& visit) const;

    /// Unique in this process, except that copies share it; 0 without blocks.
    std::uint64_t revision() const { return revision_; }

private:
    std::vector<Shared<SceneBlock>> blocks_;
    std::vector<Run> runs_;
    std::size_t size_ = 0;
    std::uint64_t revision_ = 0;
};

template <class Visit>
void SceneLines::forEachPart(std::size_t first, std::size_t end, const Visit& visit) const
{
    for (std::size_t run = first < end ? runOf(first) : 0; first < end; ++run) {
        const std::size_t before = runs_[run].firstLine;
        const std::size_t last = std::min(end, before + runs_[run].segments.size());
        if (first < last)
            visit(run, first - before, last - before);
        first = last;
    }
}

/// The lines of objects. Objects in `hidden` are not shown, even if visible themselves. Curves are
/// flattened to `tolerance` (user units, > 0).
SceneLines linesOf(const Objects& objects, const ObjectRanges& hidden, double tolerance);

/// The visible lines of a document. Curves are flattened to 0.05 mm on paper.
SceneLines linesOf(const Document& document);

} // namespace app
