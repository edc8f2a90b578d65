// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/scene_plating.h"

#include <algorithm>

namespace app {
ScenePlating::ScenePlating(const SceneLines& lines, const PaintedPart& part,
                           const PictureOptions& options, std::size_t expectedPieces)
    : lines_(lines), part_(part), plating_(options, expectedPieces)
{
}

void ScenePlating::setStyle(const Style& style)
{
    plating_.setStyle(style);
    style_ = &style;
    begun_ = false;
}

void ScenePlating::addWhole(std::size_t block, std::size_t chunk, std::size_t first,
                            std::size_t end)
{
    goTo(block);
    const FloatBox& box = block_->chunks[chunk].box;
    if (skips(box, first, end))
        return;
    const bool seen = isInside(box, plating_.seen());
    const std::span segments(block_->segments);
    while (first < end) {
        enter(first);
        const std::size_t last = std::min(end, objectEnd_);
        for (; strokes_ && first < last; ++first) {
            const clipping::Segment& line = segments[first];
            if (seen)
                plating_.strokeSeen(line, before(first));
            else
                plating_.stroke({line, std::uint32_t(first), 0}, line, before(first));
        }
        first = last;
    }
}

void ScenePlating::addPieces(std::size_t block, std::span<const clipping::Clipped> pieces)
{
    goTo(block);
    if (!style_->stroke && !style_->fill)
        return;
    for (const clipping::Clipped& piece : pieces) {
        enter(piece.source);
        if (strokes_)
            plating_.stroke(piece, block_->segments[piece.source], before(piece.source));
    }
}

void ScenePlating::goTo(std::size_t block)
{
    if (at_ == block)
        return;
    at_ = block;
    block_ = &*lines_.blocks()[block];
    objectEnd_ = 0;
}

// Whether lines in the box can be skipped. An area may cover the view although none of its lines is
// near; then its box covers the view, too, if it contains all lines of the area.
bool ScenePlating::skips(const FloatBox& box, std::size_t first, std::size_t end)
{
    if (!style_->stroke && !style_->fill)
        return true;
    if (!isOutside(box, plating_.seen()))
        return false;
    if (style_->fill
        && !(isOutside(box, plating_.filled()) && beginsObject(first) && beginsObject(end)))
        return false;
    if (style_->stroke && !begun_)
        plating_.beginStrokes();
    begun_ = style_->stroke && !style_->fill;
    return true;
}

// Whether the line is the first of its object, so that no object has lines on both sides of its
// start.
bool ScenePlating::beginsObject(std::size_t line) const
{
    if (line == 0)
        return !block_->continues;
    if (line == block_->segments.size())
        return at_ + 1 == lines_.blocks().size() || !lines_.blocks()[at_ + 1]->continues;
    return block_->firstOf(block_->objectOf(line)) == line;
}

void ScenePlating::enterObjectOf(std::size_t line)
{
    std::size_t object = line;
    objectEnd_ = line + 1;
    if (!block_->firstOfObject.empty()) {
        object = block_->objectOf(line);
        objectEnd_ = block_->firstOf(object + 1);
    }
    const std::size_t number = lines_.runs()[at_].firstObject + object;
    if (object_ == number) // it began in the previous block
        return;
    object_ = number;
    plating_.endObject();
    strokes_ = true;
    if (style_->fill || plating_.isDashed())
        findObject(object);
    if (style_->fill) {
        const bool whole = isWhole();
        if (whole)
            plating_.fill(outline_);
        strokes_ = style_->stroke || !whole;
        begun_ = false;
    }
    if (strokes_ && !begun_)
        plating_.beginStrokes();
    begun_ = strokes_;
}

void ScenePlating::findObject(std::size_t object)
{
    const auto blocks = lines_.blocks();
    std::size_t at = at_;
    while (object == 0 && blocks[at]->continues)
        object = blocks[--at]->objects() - 1;
    firstLine_ = lines_.runs()[at].firstLine + blocks[at]->firstOf(object);
    objectLines_.clear();
    outline_.clear();
    for (bool goesOn = true; goesOn; ++at, object = 0) {
        const SceneBlock& block = *blocks[at];
        const std::size_t first = block.firstOf(object), end = block.firstOf(object + 1);
        objectLines_.push_back({at, first, end});
        outline_.push_back(std::span(block.segments).subspan(first, end - first));
        goesOn =
            object + 1 == block.objects() && at + 1 < blocks.size() && blocks[at + 1]->continues;
    }
    lengths_ = LengthsBefore(outline_);
}

bool ScenePlating::isWhole() const
{
    return std::ranges::all_of(objectLines_, [&](const Lines& lines) {
        return part_.isWhole(lines.block, lines.first, lines.end);
    });
}

double ScenePlating::before(std::size_t line)
{
    if (!plating_.isDashed())
        return 0;
    return lengths_.of(lines_.runs()[at_].firstLine + line - firstLine_);
}

} // namespace app
