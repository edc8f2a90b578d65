// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/missing_part.h"

#include "app/view/hairline_drawing.h"

#include <cstring>

namespace app {

static View columnsOf(View view, const QRect& place, double pixelRatio)
{
    const double middle = (place.left() + place.width() * 0.5) / pixelRatio;
    view.centre.x = view.toDrawing({middle, 0}).x;
    view.size.x = place.width() / pixelRatio;
    return view;
}

std::vector<MissingPart> missingParts(const FrameWish& wish, const SceneFrame& frame,
                                      std::span<const QRect> places, bool hairlines,
                                      const std::stop_token& stop)
{
    const FrameKey& key = wish.key;
    PictureOptions options = wish.pictureOptions();
    options.stop = stop;
    std::vector<MissingPart> parts;
    for (const QRect& place : places) {
        const bool isAll = place.width() == key.pixels.width();
        options.view = isAll ? key.view : columnsOf(key.view, place, key.pixelRatio);
        parts.push_back({place, options.view, hairlines});
        if (!hairlines)
            parts.back().lines.kept =
                wholeDrawing(wish.document.styles(), wish.lines, frame, options);
    }
    return parts;
}

void paintPart(const MissingPart& part, Band band, const FrameWish& wish,
               const RasterOptions& options, uchar* pixels)
{
    const QRect place = part.place & QRect(0, band.top, options.width, band.height);
    if (place.isEmpty())
        return;
    const Band rows{place.top(), place.height()};
    PictureOptions look = wish.pictureOptions();
    look.view = part.view;
    RasterOptions columns = options;
    columns.width = place.width();
    QImage drawn = rasterised(part.lines, rows, columns);
    if (part.hairlines)
        paintHairlines(drawn, wish.lines, {{}, Painted::All}, wish.document.styles(), look, rows,
                       columns);
    constexpr auto bytes = std::ptrdiff_t(sizeof(QRgb)); // of a pixel; rows have no gap
    for (int y = 0; y < rows.height; ++y)
        std::memcpy(pixels
                        + ((rows.top + y) * std::ptrdiff_t(options.width) + place.left()) * bytes,
                    drawn.constScanLine(y), std::size_t(place.width() * bytes));
}

} // namespace app
