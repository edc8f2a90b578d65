// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_block.h"

namespace app {

/// A reference to an object inside its block. Valid while the `Objects` that contain it exist and
/// are not edited.
class ObjectView {
public:
    ObjectView(const ObjectBlock& block, std::size_t at, const StyleTable& styles)
        : block_(&block), at_(at), styles_(&styles)
    {
    }
    Path path() const { return block_->path(at_); }
    /// The line or point (a == b) if the object is nothing else; cheaper than `path`.
    std::optional<clipping::Segment> singleLine() const
    {
        return block_->paths.empty() ? block_->lines[at_] : block_->paths[at_].singleLine();
    }
    StyleIndex styleIndex() const { return block_->style(at_); }
    const Style& style() const { return (*styles_)[styleIndex()]; }
    StyleEntry styleEntry() const { return styles_->entry(styleIndex()); }
    bool hidden() const { return block_->isHidden(at_); }
    const Particulars& particulars() const { return *block_->particularsOf(at_); }
    ObjectRow row() const { return {path(), styleEntry(), hidden(), block_->particularsOf(at_)}; }
    Object copy() const { return {path(), style(), particulars(), hidden()}; }

private:
    const ObjectBlock* block_;
    std::size_t at_;
    const StyleTable* styles_;
};

/// Whether the object encloses an area that can be filled; single straight lines do not. (SVG fills
/// shapes that have no fill attribute, and some programs and PDF viewers then paint a hairline
/// there.)
bool hasArea(const ObjectView& object);

/// The colour of an object's lines if nothing is filled: its stroke colour or, without a stroke,
/// its fill colour if it has an area. Empty if the object is invisible.
std::optional<Colour> lineColour(const ObjectView& object);
std::optional<Colour> lineColour(const Object& object);

} // namespace app
