// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/scene_draw_list_builder.h"

#include "app/view/long_pieces.h"

#include <algorithm>

namespace app {
SceneDrawListBuilder::SceneDrawListBuilder(const SceneLines& lines, const PaintedPart& part,
                                           const PictureOptions& options,
                                           std::size_t expectedPieces)
    : lines_(lines), part_(part), cutFill_(options.region, part.which(), options.stop),
      closesAreas_(options.closesAreas && part.which() == Painted::Kept),
      leastLength_(options.leastLength), builder_(options, expectedPieces)
{
}

void SceneDrawListBuilder::setStyle(const Style& style)
{
    builder_.setStyle(style);
    style_ = &style;
    begun_ = false;
}

void SceneDrawListBuilder::add(const SharedUnderlay& image)
{
    builder_.add(image);
    begun_ = false;
}

void SceneDrawListBuilder::addWhole(std::size_t block, std::size_t chunk, std::size_t first,
                                    std::size_t end)
{
    goTo(block);
    const FloatBox& box = block_->chunks[chunk].box;
    if (skips(box, first, end))
        return;
    const bool seen = isInside(box, builder_.seen());
    const std::span segments(block_->segments);
    while (first < end) {
        enter(first);
        const std::size_t last = std::min(end, objectEnd_);
        for (; strokes_ && first < last; ++first) {
            const clipping::Segment& line = segments[first];
            if (seen)
                builder_.strokeSeen(line, before(first));
            else
                builder_.stroke({line, std::uint32_t(first), 0}, line, before(first));
        }
        first = last;
    }
}

void SceneDrawListBuilder::addPieces(std::size_t block, std::size_t chunk, std::size_t first,
                                     std::size_t end, std::span<const clipping::Clipped> pieces)
{
    goTo(block);
    if (!style_->stroke && !style_->fill)
        return;
    const bool areas = style_->fill && cutFill_.cuts();
    if (areas && pieces.empty() && isEmpty(block_->chunks[chunk].box, first, end))
        return;
    for (const clipping::Clipped& piece : pieces) {
        if (areas)
            enterUpTo(piece.source, first);
        enter(piece.source);
        if (strokes_)
            builder_.stroke(piece, block_->segments[piece.source], before(piece.source));
    }
    if (areas)
        enterUpTo(end, first);
}

// Enters each object with a line in [line, end).
void SceneDrawListBuilder::enterUpTo(std::size_t end, std::size_t& line)
{
    while (line < end) {
        enter(line);
        line = objectEnd_;
    }
}

// Whether no area of these lines has a visible part, as far as their box tells.
bool SceneDrawListBuilder::isEmpty(const FloatBox& box, std::size_t first, std::size_t end) const
{
    return beginsObject(first) && beginsObject(end)
           && (isOutside(box, builder_.filled())
               || cutFill_.remains(box.window()) == Remains::Gone);
}

void SceneDrawListBuilder::goTo(std::size_t block)
{
    if (at_ == block)
        return;
    at_ = block;
    block_ = &*lines_.blocks()[block];
    objectEnd_ = 0;
}

// Whether lines in the box can be skipped. An area may cover the view although none of its lines is
// near; then its box covers the view, too, if it contains all lines of the area.
bool SceneDrawListBuilder::skips(const FloatBox& box, std::size_t first, std::size_t end)
{
    if (!style_->stroke && !style_->fill)
        return true;
    if (!isOutside(box, builder_.seen()))
        return false;
    if (style_->fill
        && !(isOutside(box, builder_.filled()) && beginsObject(first) && beginsObject(end)))
        return false;
    if (style_->stroke && !begun_)
        builder_.beginStrokes();
    begun_ = style_->stroke && !style_->fill;
    return true;
}

// Whether the line is the first of its object, so that no object has lines on both sides of its
// start.
bool SceneDrawListBuilder::beginsObject(std::size_t line) const
{
    if (line == 0)
        return !block_->continues;
    if (line == block_->segments.size())
        return at_ + 1 == lines_.blocks().size() || !lines_.blocks()[at_ + 1]->continues;
    return block_->firstOf(block_->objectOf(line)) == line;
}

void SceneDrawListBuilder::enterObjectOf(std::size_t line)
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
    builder_.endObject();
    strokes_ = true;
    if (style_->fill || builder_.isDashed())
        findObject(object);
    if (style_->fill) {
        begun_ = false;
        strokes_ = !fillObject() || style_->stroke;
        if (closesAreas_ && strokes_ && cutFill_.cuts())
            strokes_ = !strokeCut();
    }
    if (strokes_ && !begun_)
        builder_.beginStrokes();
    begun_ = strokes_;
}

void SceneDrawListBuilder::findObject(std::size_t object)
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

// Fills what is painted of the current object. False: nothing, because its lines are not all
// painted and the windows are not known; its outline is shown then.
bool SceneDrawListBuilder::fillObject()
{
    if (!cutFill_.cuts()) {
        const bool whole = isWhole();
        if (whole)
            builder_.fill(outline_);
        return whole;
    }
    cutOutline_.clear();
    isCut_ = false;
    const Remains remains = cutFill_.remains(boxOf(outline_));
    if (remains == Remains::Whole)
        builder_.fill(outline_);
    if (remains == Remains::Pieces) {
        cutOutline_ = cutFill_.clip(outline_, style_->fillRule);
        isCut_ = !cutOutline_.empty();
        if (closesAreas_ && style_->stroke && leastLength_ > 0)
            cutOutline_ = withoutShortRings(std::move(cutOutline_), leastLength_);
        builder_.fill({std::span<const clipping::Segment>(cutOutline_)});
    }
    return true;
}

// Strokes the outline of what is left of the current area. False if the area is not cut.
bool SceneDrawListBuilder::strokeCut()
{
    if (!isCut_)
        return false;
    const Outline rings{std::span<const clipping::Segment>(cutOutline_)};
    LengthsBefore lengths(rings);
    builder_.beginStrokes();
    for (std::size_t i = 0; i < cutOutline_.size(); ++i)
        builder_.stroke({cutOutline_[i], std::uint32_t(i), 0}, cutOutline_[i],
                        builder_.isDashed() ? lengths.of(i) : 0);
    builder_.endObject();
    return true;
}

bool SceneDrawListBuilder::isWhole() const
{
    return std::ranges::all_of(objectLines_, [&](const Lines& lines) {
        return part_.isWhole(lines.block, lines.first, lines.end);
    });
}

double SceneDrawListBuilder::before(std::size_t line)
{
    if (!builder_.isDashed())
        return 0;
    return lengths_.of(lines_.runs()[at_].firstLine + line - firstLine_);
}

} // namespace app
