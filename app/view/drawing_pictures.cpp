// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/drawing_pictures.h"

#include <QRegion>

#include <algorithm>
#include <limits>

namespace app {

constexpr std::size_t mostPictures = 2; // of a large screen 8 megabytes each

DrawingKey drawingKeyOf(const FrameWish& wish)
{
    const FrameKey& key = wish.key;
    return {{.lines = key.lines,
             .images = key.images,
             .view = key.view,
             .pixels = key.pixels,
             .pixelRatio = key.pixelRatio},
            wish.options.page,
            wish.options.leastWidth,
            wish.options.strokes};
}

DrawingPictures::Found DrawingPictures::find(const DrawingKey& key) const
{
    const QRect image({}, key.frame.pixels);
    Found best{QImage(image.size(), QImage::Format_ARGB32_Premultiplied), {image}};
    int leastMoved = std::numeric_limits<int>::max();
    const std::scoped_lock lock(lock_);
    for (const Kept& kept : kept_) {
        const auto by = wholePixelsBetween(kept.key.frame, key.frame);
        DrawingKey there = kept.key;
        there.frame.view.centre = key.frame.view.centre;
        if (!by || !(there == key) || by->manhattanLength() >= leastMoved)
            continue;
        leastMoved = by->manhattanLength();
        const QRegion missing = QRegion(image) - QRegion(image.translated(*by));
        best = {by->isNull() ? kept.picture : kept.picture.copy(image.translated(-*by)),
                {missing.begin(), missing.end()}};
    }
    return best;
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
