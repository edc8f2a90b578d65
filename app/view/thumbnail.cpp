// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/thumbnail.h"

#include "app/document/legacy.h"
#include "app/view/raster.h"

#include <QPainter>

#include <algorithm>

namespace app {

namespace {

constexpr double margin = 4, outline = 1.5; // points

Colour plain(const QColor& colour)
{
    return {std::uint8_t(colour.red()), std::uint8_t(colour.green()), std::uint8_t(colour.blue())};
}

/// The page fills the picture, around the clip window; but the window is seen whole.
void cover(View& view, const Sheet& sheet)
{
    const Point page = sheet.page.size, window = sheet.window.max - sheet.window.min;
    const double filling = std::max(view.size.x / page.x, view.size.y / page.y);
    view.fit(sheet.window, margin + outline);
    if (!(view.zoom < filling) || window == Point(0, 0))
        view.zoom = filling;
    const Point half = view.size / view.zoom * 0.5, middle = sheet.page.min + page * 0.5;
    for (glm::length_t axis = 0; axis < 2; ++axis) {
        const double low = sheet.page.min[axis] + half[axis];
        const double high = sheet.page.min[axis] + page[axis] - half[axis];
        view.centre[axis] = low > high ? middle[axis] : std::clamp(view.centre[axis], low, high);
    }
}

} // namespace

QImage thumbnail(const Sheet& sheet, const QSize& points, double pixelRatio,
                 const ThumbnailColours& colours)
{
    const EditedDocument document(documentOf(sheet));
    Scene scene(document);
    View view;
    view.size = {points.width(), points.height()};
    cover(view, sheet);
    const auto frame =
        scene.clip(clipping::algorithms().front().corrected, sheet.window, Scene::Removed::Kept);
    PictureOptions options{.view = view, .page = plain(colours.page)};
    options.leastWidth = 0.5;
    const QSize pixels = points * pixelRatio;
    const QImage lines = rasterised(picture(sheet, scene, frame, options), {0, pixels.height()},
                                    {pixels.width(), pixelRatio, colours.ghost});
    QImage image(pixels, QImage::Format_RGB32);
    image.fill(colours.page);
    QPainter painter(&image);
    painter.drawImage(QRect({}, pixels), lines);
    painter.scale(pixelRatio, pixelRatio);
    painter.setPen(QPen(colours.accent, outline));
    const Point a = view.toScreen(sheet.window.min), b = view.toScreen(sheet.window.max);
    painter.drawRect(QRectF(QPointF(a.x, a.y), QPointF(b.x, b.y)));
    painter.end();
    image.setDevicePixelRatio(pixelRatio);
    return image;
}

} // namespace app
