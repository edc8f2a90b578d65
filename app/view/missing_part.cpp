// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/missing_part.h"

#include <QRegion>

namespace app {

static View columnsOf(View view, const QRect& place, double pixelRatio)
{
    const double middle = (place.left() + place.width() * 0.5) / pixelRatio;
    view.centre.x = view.toDrawing({middle, 0}).x;
    view.size.x = place.width() / pixelRatio;
    return view;
}

std::vector<MissingPart> missingParts(const FrameKey& key, const std::optional<QPoint>& moved)
{
    const QRect all({}, key.pixels);
    if (!moved)
        return {{.place = all, .view = key.view}};
    std::vector<MissingPart> parts;
    for (const QRect& place : QRegion(all) - QRegion(all.translated(*moved)))
        parts.push_back({place, columnsOf(key.view, place, key.pixelRatio), {}});
    return parts;
}

} // namespace app
