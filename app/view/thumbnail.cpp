// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/thumbnail.h"

#include "app/scene/compared_window.h"
#include "app/scene/scene_clipping.h"
#include "app/scene/scene_lines.h"
#include "app/view/picture.h"
#include "app/view/raster.h"

#include <QPainter>

#include <algorithm>

namespace app {

namespace {

constexpr double margin = 4, outlineWidth = 1.5; // points

/// Lets the page fill the picture around the clip window, but keeps the whole window visible.
void cover(View& view, const Page& page, const clipping::Window& window)
{
    const double filling = std::max(view.size.x / page.size.x, view.size.y / page.size.y);
    view.fit(window, margin + outlineWidth);
    if (!(view.zoom < filling) || window.max == window.min)
        view.zoom = filling;
    const Point half = view.size / view.zoom * 0.5, middle = page.min + page.size * 0.5;
    for (glm::length_t axis = 0; axis < 2; ++axis) {
        const double low = page.min[axis] + half[axis];
        const double high = page.min[axis] + page.size[axis] - half[axis];
        view.centre[axis] = low > high ? middle[axis] : std::clamp(view.centre[axis], low, high);
    }
}

} // namespace

QImage thumbnail(const Document& document, const QSize& points, double pixelRatio,
                 const ThumbnailColours& colours)
{
    const ComparedWindow shown = comparedWindow(document.windows(), document.page());
    const clipping::Window& window = shown.window;
    View view;
    view.size = {points.width(), points.height()};
    cover(view, document.page(), window);
    const SceneLines lines = linesOf(document);
    SceneClipping clips;
    const ClipRegion region = regionOf(document.windows(), document.page());
    const SceneFrame frame =
        clips.clip(lines, region, clipping::exactAlgorithm().corrected.clipAll);
    PictureOptions options;
    options.view = view;
    options.region = &region;
    options.leastWidth = 0.5;
    const std::vector<SeenUnderlay> underlays = seenUnderlays(document);
    options.underlays = underlays;
    const QSize pixels = points * pixelRatio;
    const QImage art =
        rasterised(picture(document.styles(), lines, frame, options), {0, pixels.height()},
                   {pixels.width(), pixelRatio, colours.ghost});
    QImage image(pixels, QImage::Format_RGB32);
    image.fill(colours.page);
    QPainter painter(&image);
    painter.drawImage(QRect({}, pixels), art);
    painter.scale(pixelRatio, pixelRatio);
    painter.setPen(QPen(colours.accent, outlineWidth));
    const Point a = view.toScreen(window.min), b = view.toScreen(window.max);
    if (!shown.isPage)
        painter.drawRect(QRectF(QPointF(a.x, a.y), QPointF(b.x, b.y)));
    painter.end();
    image.setDevicePixelRatio(pixelRatio);
    return image;
}

} // namespace app
