// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/scene_draw_list_builder.h"

namespace app {

/// Builds a draw list of the strokes of some lines, chunk by chunk in order.
class StrokeListBuilder {
public:
    /// All of them must outlive it.
    StrokeListBuilder(const StyleTable& styles, const SceneLines& lines, const PaintedPart& part,
                      const PictureOptions& options)
        : styles_(styles), lines_(lines), builder_(lines, part, options, 0)
    {
    }

    /// Adds pieces of a chunk; `source` is numbered within the block.
    void add(std::size_t block, std::size_t chunk, std::span<const clipping::Clipped> pieces)
    {
        const SceneBlock& in = *lines_.blocks()[block];
        const SceneChunk& added = in.chunks[chunk];
        if (pieces.empty() || !styles_[added.style].stroke)
            return;
        if (index_ != added.style) {
            style_ = styles_[*(index_ = added.style)];
            style_.fill.reset();
            builder_.setStyle(style_);
        }
        builder_.addPieces(block, chunk, added.first, in.endOfChunk(chunk), pieces);
    }
    DrawList take() { return builder_.take(); }

private:
    const StyleTable& styles_;
    const SceneLines& lines_;
    SceneDrawListBuilder builder_;
    Style style_;
    std::optional<StyleIndex> index_;
};

} // namespace app
