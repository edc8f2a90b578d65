// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/drawing_pictures.h"

#include <algorithm>
#include <ranges>

namespace app {

constexpr std::size_t mostPictures = 2; // of a large screen 8 megabytes each

DrawingKey drawingKeyOf(const FrameWish& wish)
{
    const FrameKey& key = wish.key;
    return {
        {.lines = key.lines, .view = key.view, .pixels = key.pixels, .pixelRatio = key.pixelRatio},
        wish.options.page,
        wish.options.leastWidth,
        wish.options.strokes};
}

QImage DrawingPictures::find(const DrawingKey& key) const
{
    const std::scoped_lock lock(lock_);
    const auto found = std::ranges::find(kept_, key, &Kept::key);
    return found == kept_.end() ? QImage() : found->picture;
}

std::optional<DrawingPictures::Moved> DrawingPictures::findMoved(const DrawingKey& key) const
{
    const QRect image({}, key.frame.pixels);
    const std::scoped_lock lock(lock_);
    for (const Kept& kept : kept_ | std::views::reverse) {
        const auto by = wholePixelsBetween(kept.key.frame, key.frame);
        DrawingKey there = kept.key;
        there.frame.view.centre = key.frame.view.centre;
        if (by && there == key && image.translated(*by).intersects(image))
            return Moved{kept.picture.copy(image.translated(-*by)), *by};
    }
    return {};
}

void DrawingPictures::keep(const DrawingKey& key, const QImage& picture)
{
    const std::scoped_lock lock(lock_);
    std::erase_if(kept_, [&](const Kept& kept) { return kept.key == key; });
    if (kept_.size() == mostPictures)
        kept_.erase(kept_.begin());
    kept_.push_back({key, picture});
}

} // namespace app
